package org.trigrid.editor

fun main() {
}
