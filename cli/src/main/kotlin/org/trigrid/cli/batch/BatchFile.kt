package org.trigrid.cli.batch

import java.nio.file.Path

/** A file to be meshed and where its mesh goes, before several domains are numbered. */
internal class BatchFile(val input: Path, val output: Path)
