package org.trigrid.cli

fun main() {
}
