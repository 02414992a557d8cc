package org.trigrid.editor.app

import org.junit.jupiter.api.extension.ConditionEvaluationResult
import org.junit.jupiter.api.extension.ExecutionCondition
import org.junit.jupiter.api.extension.ExtensionContext

/** Skips tests of windows where no window can be opened, and says so in the output of the build. */
internal class NeedsDisplay : ExecutionCondition {
    override fun evaluateExecutionCondition(context: ExtensionContext): ConditionEvaluationResult {
        if (isThere()) return ConditionEvaluationResult.enabled("there is a display")
        if (context.testMethod.isEmpty) println("Skipped ${context.requiredTestClass.simpleName}: $REASON")
        return ConditionEvaluationResult.disabled(REASON)
    }

    private companion object {
        const val REASON = "there is no display to open windows on; `xvfb-run -a mvn verify` tests them as well"

        /** On Linux a display has to be named; elsewhere there is one unless Java is told that there is none. */
        fun isThere(): Boolean {
            val isLinux = System.getProperty("os.name").lowercase().contains("linux")
            val isNamed = !System.getenv("DISPLAY").isNullOrEmpty()
            return if (isLinux) isNamed else !java.lang.Boolean.getBoolean("java.awt.headless")
        }
    }
}
