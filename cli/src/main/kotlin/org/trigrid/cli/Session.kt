package org.trigrid.cli

/** What one run of the program hands to its commands. */
internal class Session(val terminal: Terminal, val cancellation: Cancellation)
