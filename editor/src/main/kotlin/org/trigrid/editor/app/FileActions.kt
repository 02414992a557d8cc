package org.trigrid.editor.app

import javafx.animation.PauseTransition
import javafx.stage.FileChooser
import javafx.stage.Window
import javafx.util.Duration
import org.trigrid.diagnostics.TriGridException
import org.trigrid.editor.document.EditorDocument
import org.trigrid.editor.files.Autosave
import org.trigrid.editor.files.DocumentFile
import org.trigrid.editor.files.OptionMemory
import org.trigrid.editor.files.Preferences
import org.trigrid.editor.session.Change
import org.trigrid.editor.session.EditorSession
import java.io.IOException
import java.nio.file.Path
import java.util.concurrent.Executor
import kotlin.io.path.exists

/** New, open, save and close, so that nothing is lost. */
internal class FileActions(
    private val session: EditorSession,
    private val preferences: Preferences,
    private val autosave: Autosave,
    private val options: OptionMemory,
    private val dialogs: Dialogs,
    private val worker: Executor,
    private val window: () -> Window?,
) {
    /** Hears that another document is shown. */
    var opened: () -> Unit = {}

    private val pause = PauseTransition(Duration.seconds(AUTOSAVE_SECONDS))

    init {
        pause.setOnFinished { keepCopy() }
        session.listen { if (it == Change.DOCUMENT) pause.playFromStart() }
    }

    fun new() {
        if (!mayLeave()) return
        session.open(empty(), null)
        opened()
    }

    /** A drawing to begin with, to be meshed as people wanted the last ones to be. */
    fun empty(): EditorDocument = EditorDocument.EMPTY.with { options(options.options()) }

    fun open() {
        if (!mayLeave()) return
        val chooser = chooser("Open a domain")
        chooser.extensionFilters.addAll(
            FileChooser.ExtensionFilter("Domains", DocumentFile.patterns),
            FileChooser.ExtensionFilter("All files", "*"),
        )
        chooser.showOpenDialog(window())?.let { show(it.toPath()) }
    }

    /** Opens [file], once the document before is saved or given up. */
    fun open(file: Path) {
        if (mayLeave()) show(file)
    }

    fun show(file: Path) = attempt("$file cannot be opened") {
        if (!file.exists()) preferences.forget(file)
        val read = DocumentFile.read(file)
        val recovered = if (read.isProject) autosave.recovered(file) else null
        if (recovered != null && dialogs.askToRecover(file.fileName.toString())) {
            session.recover(recovered, file)
        } else {
            autosave.discard(file)
            if (read.isProject) session.open(read.document, file) else openLoops(read.document, file)
        }
        preferences["folder"] = file.toAbsolutePath().parent?.toString()
        preferences.remember(file)
        opened()
    }

    private fun openLoops(loops: EditorDocument, file: Path) =
        session.open(loops.with { options(options.options()) }, null, file.fileName.toString())

    /** Offers what a crash left of a drawing without a file. @return whether it is shown. */
    fun offerRecovery(): Boolean {
        val recovered = autosave.adoptUntitled()?.takeIf { !it.isEmpty } ?: return false
        if (!dialogs.askToRecover(EditorSession.UNTITLED)) {
            autosave.discard(null)
            return false
        }
        session.recover(recovered, null)
        opened()
        return true
    }

    /** @return whether it was saved. */
    fun save(): Boolean {
        val file = session.file ?: return saveAs()
        return write(file)
    }

    fun saveAs(): Boolean {
        val chooser = chooser("Save the project")
        chooser.extensionFilters.add(FileChooser.ExtensionFilter("TriGrid project", "*${DocumentFile.ENDING}"))
        chooser.initialFileName = session.file?.fileName?.toString() ?: DocumentFile.projectName(Path.of(session.title))
        val chosen = chooser.showSaveDialog(window())?.toPath() ?: return false
        val file = DocumentFile.withEnding(chosen)
        return mayWrite(chosen, file) && write(file)
    }

    /** Whether [file] may be written where the chooser, which asks about what is there already, was told [chosen]. */
    fun mayWrite(chosen: Path, file: Path): Boolean = file == chosen || !file.exists() || dialogs.askToReplace(file.fileName.toString())

    /** Whether the document may be left: it is saved, or people do not want it. */
    fun mayLeave(): Boolean {
        if (session.isModified && !session.document.isEmpty) {
            when (dialogs.askToSave(session.title)) {
                Dialogs.Answer.SAVE -> if (!save()) return false
                Dialogs.Answer.DISCARD -> Unit
                Dialogs.Answer.CANCEL -> return false
            }
        }
        pause.stop()
        autosave.discard(session.file)
        return true
    }

    fun write(file: Path): Boolean = attempt("$file cannot be saved") {
        val document = session.document
        val before = session.file
        DocumentFile.write(file, document)
        session.saved(document, file)
        pause.stop()
        autosave.discard(before)
        autosave.discard(file)
        preferences["folder"] = file.toAbsolutePath().parent?.toString()
        preferences.remember(file)
        session.say("Saved ${file.fileName}")
    }

    /** Does [work]; tells what went wrong if it did. */
    fun attempt(heading: String, work: () -> Unit): Boolean = try {
        work()
        true
    } catch (error: TriGridException) {
        dialogs.tell(heading, error.message.orEmpty())
        false
    } catch (error: IOException) {
        dialogs.tell(heading, reason(error))
        false
    }

    fun chooser(title: String): FileChooser {
        val chooser = FileChooser()
        chooser.title = title
        val folder = session.file?.toAbsolutePath()?.parent ?: preferences["folder"]?.let { Path.of(it) }
        if (folder != null && folder.exists()) chooser.initialDirectory = folder.toFile()
        return chooser
    }

    private fun keepCopy() {
        if (!session.isModified) return
        val document = session.document
        val file = session.file
        val ticket = autosave.ticket
        worker.execute {
            try {
                autosave.write(file, document, ticket)
            } catch (_: IOException) {
                // The next change tries again; saving by hand tells what is wrong.
            }
        }
    }

    private fun reason(error: IOException): String = when (error) {
        is java.nio.file.NoSuchFileException -> "There is no such file or folder."
        is java.nio.file.AccessDeniedException -> "Access was denied. Choose another folder, or change the rights of this one."
        else -> error.message ?: error.toString()
    }

    private companion object {
        const val AUTOSAVE_SECONDS = 1.5
    }
}
