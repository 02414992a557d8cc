package org.trigrid.api

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.trigrid.MeshOptions
import java.nio.file.Path
import kotlin.io.path.createParentDirectories
import kotlin.io.path.readText
import kotlin.io.path.writeText

/**
 * The public API is what `api/core.api` says, so that no change of it goes unseen.
 *
 * After a change that is meant: `mvn -pl core clean test -Dtest=ApiDumpTest -Dtrigrid.updateApi=true`, then look at the
 * difference and commit it. Without `clean`, classes whose sources are gone may still lie about.
 */
class ApiDumpTest {
    @Test
    fun `the public API is the one written down`() {
        val classes = Path.of(MeshOptions::class.java.protectionDomain.codeSource.location.toURI())
        val dump = ApiDump(classes).text()
        val file = Path.of("api", "core.api")
        if (java.lang.Boolean.getBoolean("trigrid.updateApi")) file.createParentDirectories().writeText(dump)
        assertEquals(file.readText(), dump, "if the change is meant, run again with -Dtrigrid.updateApi=true")
    }
}
