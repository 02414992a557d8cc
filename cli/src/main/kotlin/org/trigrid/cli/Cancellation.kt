package org.trigrid.cli

import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit

/**
 * Whether the user asked to stop.
 *
 * On Ctrl-C the JVM starts its shutdown hooks while the run goes on; the hook made here asks the run to stop and waits
 * until it has cleaned up, so that no partial file is left. The JVM then ends with 130 by itself.
 */
internal class Cancellation {
    private val ended = CountDownLatch(1)

    @Volatile
    var isRequested: Boolean = false
        private set

    fun request() {
        isRequested = true
    }

    fun runHasEnded() = ended.countDown()

    fun listenToInterrupts() {
        Runtime.getRuntime().addShutdownHook(
            Thread {
                request()
                ended.await(PATIENCE_SECONDS, TimeUnit.SECONDS)
            },
        )
    }

    private companion object {
        const val PATIENCE_SECONDS = 10L
    }
}
