package org.trigrid.domain

/** A place that tells to which region the part of the domain round it belongs. */
internal class RegionMarker(val x: Double, val y: Double, val region: Region)
