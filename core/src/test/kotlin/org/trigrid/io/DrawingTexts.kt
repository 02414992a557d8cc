package org.trigrid.io

import org.trigrid.domain.Domain
import java.nio.file.Path

/** Reads drawings given as text. */
internal object DrawingTexts {
    fun read(format: DomainFormat, text: String, division: CurveDivision = CurveDivision.DEFAULT): List<NamedDomain> =
        format.read(DomainText(Path.of("drawing" + format.endings[0]), text, division))

    fun one(format: DomainFormat, text: String, division: CurveDivision = CurveDivision.DEFAULT): Domain =
        read(format, text, division).single().domain

    fun spaced(spacing: Double): CurveDivision = CurveDivision.DEFAULT.withSpacing(spacing, 1.0)
}
