package org.trigrid.parallel

import org.trigrid.diagnostics.MeshingCancelledException
import java.util.concurrent.Executor
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The caller's thread and those lent to it. Work comes as tasks that do not depend on each other, so that its result does not
 * depend on how many threads share it.
 *
 * The caller works too: tasks get done even if the executor never finds the time. Only the caller's thread reports, so a
 * monitor hears of the work from one thread and may end it, wherever it is.
 */
internal class Crew(private val threads: Int, private val executor: Executor) {
    /**
     * Does the tasks 0 until [count] and returns when all are done, with what they wrote seen by the caller.
     *
     * @param report hears of the progress, from 0 to 1 but not always rising, and may throw to end the work.
     * @param task does one task; calls what it is given with its progress from 0 to 1, at least every few milliseconds.
     */
    fun run(count: Int, report: (Double) -> Unit, task: (index: Int, progress: (Double) -> Unit) -> Unit) {
        val shift = Shift(count, report, task)
        for (helper in 1 until Math.min(threads, count)) executor.execute { shift.help() }
        shift.lead()
    }

    private class Shift(
        private val count: Int,
        private val report: (Double) -> Unit,
        private val task: (index: Int, progress: (Double) -> Unit) -> Unit,
    ) {
        private val lock = ReentrantLock()
        private val taskEnded = lock.newCondition()
        private var next = 0
        private var running = 0
        private var failure: Throwable? = null

        @Volatile
        private var done = 0

        @Volatile
        private var isEnding = false

        fun lead() {
            val tell: (Double) -> Unit = { part ->
                if (isEnding) throw MeshingCancelledException()
                report(Math.min(1.0, (done + part) / count))
            }
            try {
                work(tell)
                while (awaitTask()) tell(0.0)
            } catch (problem: Throwable) {
                fail(problem)
            }
            awaitEnd()
            failure?.let { throw it }
        }

        fun help() {
            try {
                work { if (isEnding) throw MeshingCancelledException() }
            } catch (problem: Throwable) {
                fail(problem)
            }
        }

        /** Does tasks as long as there are any. */
        private fun work(progress: (Double) -> Unit) {
            while (true) {
                val index = take()
                if (index < 0) return
                var isDone = false
                try {
                    task(index, progress)
                    isDone = true
                } finally {
                    finish(isDone)
                }
            }
        }

        private fun take(): Int = lock.withLock {
            if (next == count || isEnding) return -1
            running++
            next++
        }

        private fun finish(isDone: Boolean) = lock.withLock {
            running--
            if (isDone) done++
            taskEnded.signalAll()
        }

        /** Waits a little for the tasks that others have begun; false if there are none. */
        private fun awaitTask(): Boolean = lock.withLock {
            if (running > 0) taskEnded.await(PATIENCE, TimeUnit.MILLISECONDS)
            running > 0
        }

        /** The first failure counts; the others are its consequence. */
        private fun fail(problem: Throwable) = lock.withLock {
            if (failure == null) failure = problem
            isEnding = true
        }

        /** Nobody may still write when the caller goes on, be it with an exception. */
        private fun awaitEnd() = lock.withLock {
            while (running > 0) taskEnded.awaitUninterruptibly()
        }
    }

    companion object {
        /** Milliseconds between two reports of a caller who has nothing left to do. */
        private const val PATIENCE = 10L

        /** The caller alone. */
        @JvmField
        val CALLER: Crew = Crew(1) { throw IllegalStateException("nobody is to help") }
    }
}
