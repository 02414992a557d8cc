package org.trigrid.editor.app

import javafx.application.Platform
import javafx.scene.control.Alert
import javafx.scene.control.Button
import javafx.scene.control.ButtonBar
import javafx.scene.control.ButtonType
import javafx.stage.Window
import org.trigrid.editor.inspector.NumberQuestion

/** Questions that stop the window until they are answered. */
internal class Dialogs(private val owner: () -> Window?) {
    enum class Answer { SAVE, DISCARD, CANCEL }

    /** Whether to save what would be lost. */
    fun askToSave(name: String): Answer {
        val save = ButtonType("Save", ButtonBar.ButtonData.YES)
        val discard = ButtonType("Do not save", ButtonBar.ButtonData.NO)
        val alert = alert(Alert.AlertType.CONFIRMATION, "Save the changes to “$name”?", "They are lost if you do not.")
        alert.buttonTypes.setAll(save, discard, ButtonType.CANCEL)
        return when (alert.showAndWait().orElse(ButtonType.CANCEL)) {
            save -> Answer.SAVE
            discard -> Answer.DISCARD
            else -> Answer.CANCEL
        }
    }

    fun askToRecover(name: String): Boolean {
        val recover = ButtonType("Recover", ButtonBar.ButtonData.YES)
        // No button for Esc, which must not throw the copy away.
        val discard = ButtonType("Discard", ButtonBar.ButtonData.OTHER)
        val alert = alert(
            Alert.AlertType.CONFIRMATION, "Recover unsaved changes to “$name”?",
            "TriGrid was closed unexpectedly. It kept a copy of what you had not saved.",
        )
        alert.buttonTypes.setAll(recover, discard)
        return alert.showAndWait().orElse(recover) == recover
    }

    /** Whether the file may be written over. */
    fun askToReplace(name: String): Boolean {
        val replace = ButtonType("Replace", ButtonBar.ButtonData.OTHER)
        val alert = alert(Alert.AlertType.CONFIRMATION, "Replace “$name”?", "There is a file of this name. What it holds is lost if you replace it.")
        alert.buttonTypes.setAll(replace, ButtonType.CANCEL)
        // Enter may still be meant for the chooser, so it must not replace.
        val cancel = alert.dialogPane.lookupButton(ButtonType.CANCEL) as Button
        cancel.isDefaultButton = true
        alert.setOnShown { Platform.runLater { cancel.requestFocus() } }
        return alert.showAndWait().orElse(ButtonType.CANCEL) == replace
    }

    fun tell(heading: String, message: String) {
        alert(Alert.AlertType.ERROR, heading, message).show()
    }

    fun inform(heading: String, message: String) {
        alert(Alert.AlertType.INFORMATION, heading, message).show()
    }

    /** Numbers typed into named fields; null if the dialog is cancelled. */
    fun askForNumbers(title: String, vararg questions: NumberQuestion): List<Double>? = NumberDialog(owner(), title, questions.toList()).ask()

    private fun alert(type: Alert.AlertType, heading: String, message: String): Alert {
        val alert = Alert(type, message)
        alert.initOwner(owner())
        alert.headerText = heading
        alert.title = "TriGrid"
        return alert
    }
}
