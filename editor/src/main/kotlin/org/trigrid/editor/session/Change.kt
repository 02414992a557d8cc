package org.trigrid.editor.session

/** What listeners of a session are told has changed. */
internal enum class Change { DOCUMENT, SELECTION, TOOL, PREVIEW, PROBLEMS, PROGRESS, MESH, PLAYBACK, VIEW, MESSAGE, FILE }
