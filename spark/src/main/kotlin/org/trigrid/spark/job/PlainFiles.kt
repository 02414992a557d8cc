package org.trigrid.spark.job

import org.apache.hadoop.conf.Configuration
import org.apache.hadoop.fs.FileSystem
import org.apache.hadoop.fs.LocalFileSystem
import org.apache.hadoop.fs.Path

/** File systems without the files of checksums that Hadoop puts beside those of a local disk, and looks for there. */
internal object PlainFiles {
    fun systemOf(path: Path, configuration: Configuration): FileSystem {
        val fileSystem = path.getFileSystem(configuration)
        return (fileSystem as? LocalFileSystem)?.rawFileSystem ?: fileSystem
    }
}
