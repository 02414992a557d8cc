package org.trigrid.spark

/** Why an outline, or one of its domains, has no mesh. */
public enum class OutlineError {
    /** There is no text, or its file cannot be read. */
    FILE,

    /** The text is not what its format asks for. */
    FORMAT,

    /** The domain has faults; all of them are told. */
    DOMAIN,

    /** A line or curve cannot be divided as asked, or an option cannot be. */
    SHAPE,

    /** The size function gave no size. */
    SIZE,

    /** The mesh would have more elements than allowed, or than the memory holds. */
    TOO_LARGE,

    /** Something that should not happen: a defect of TriGrid, or an exception of the size function. */
    DEFECT,
}
