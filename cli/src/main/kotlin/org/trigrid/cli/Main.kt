@file:JvmName("Main")

package org.trigrid.cli

fun main() {
}
