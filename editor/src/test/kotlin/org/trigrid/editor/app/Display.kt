package org.trigrid.editor.app

/** Whether windows can be opened here. */
internal object Display {
    /** On Linux a display has to be named; elsewhere there is one unless Java is told that there is none. */
    @JvmStatic
    fun isThere(): Boolean {
        val isLinux = System.getProperty("os.name").lowercase().contains("linux")
        val isNamed = !System.getenv("DISPLAY").isNullOrEmpty()
        return if (isLinux) isNamed else !java.lang.Boolean.getBoolean("java.awt.headless")
    }
}
