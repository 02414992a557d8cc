package org.trigrid.editor.meshing

import org.trigrid.diagnostics.Fault
import org.trigrid.diagnostics.InvalidDomainException
import org.trigrid.diagnostics.TriGridException
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainCheck
import org.trigrid.editor.document.EditorDocument

/** The domain of a document and all that is wrong with it. Immutable. */
internal class DomainInspection(
    val document: EditorDocument,
    /** The domain, or null where it cannot be made or has faults. */
    val domain: Domain?,
    val problems: List<Problem>,
) {
    val faultCount: Int get() = problems.count { it.isFault }

    companion object {
        private const val MOST_WARNINGS_NODES = 50_000

        /** Inspects a document; takes as long as it takes, so off the window's thread. */
        fun of(document: EditorDocument): DomainInspection {
            if (document.isEmpty) return DomainInspection(document, null, emptyList())
            return try {
                ofDomain(document, document.project.toDomain())
            } catch (_: InvalidDomainException) {
                DomainInspection(document, null, problems(document, document.project.faults()))
            } catch (error: TriGridException) {
                DomainInspection(document, null, listOf(Problem("No domain", error.message.orEmpty(), 0.0, 0.0, true)))
            }
        }

        private fun ofDomain(document: EditorDocument, domain: Domain): DomainInspection {
            val faults = DomainCheck.check(domain)
            if (faults.isNotEmpty()) return DomainInspection(document, null, problems(document, faults))
            val warnings = if (domain.nodeCount > MOST_WARNINGS_NODES) emptyList() else DomainCheck.warnings(domain)
            val listed = warnings.map {
                Problem(ProblemWords.title(it.kind), ProblemWords.shortened(it.message), it.x, it.y, false)
            }
            return DomainInspection(document, domain, listed)
        }

        private fun problems(document: EditorDocument, faults: List<Fault>): List<Problem> = faults.map {
            Problem(ProblemWords.title(it.kind), ProblemWords.shortened(it.message), it.x, it.y, true, FaultFixes.of(document, it))
        }
    }
}
