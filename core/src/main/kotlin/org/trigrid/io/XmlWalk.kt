package org.trigrid.io

import org.trigrid.diagnostics.FileFormatException
import java.io.Reader
import javax.xml.stream.XMLInputFactory
import javax.xml.stream.XMLStreamConstants
import javax.xml.stream.XMLStreamException
import javax.xml.stream.XMLStreamReader

/** Goes through the elements of an XML text one after the other. Neither document types nor entities of its own are known. */
internal class XmlWalk(reader: Reader, private val source: String) : Complaint {
    enum class Event { START, END, TEXT, DONE }

    private var line = 1
    private var column = 1
    private val xml: XMLStreamReader = guarded { factory().createXMLStreamReader(reader) }

    /** How many elements are open. */
    var depth: Int = 0
        private set

    /** Of the element that starts or ends, without its prefix. */
    val name: String get() = xml.localName

    val text: String get() = xml.text

    fun attribute(name: String): String? = xml.getAttributeValue(null, name)

    fun next(): Event {
        while (true) {
            when (step()) {
                XMLStreamConstants.START_ELEMENT -> {
                    if (++depth > MAX_DEPTH) fail("more than $MAX_DEPTH elements in one another")
                    return Event.START
                }
                XMLStreamConstants.END_ELEMENT -> {
                    depth--
                    return Event.END
                }
                XMLStreamConstants.CHARACTERS, XMLStreamConstants.CDATA -> return Event.TEXT
                XMLStreamConstants.END_DOCUMENT -> return Event.DONE
                XMLStreamConstants.ENTITY_REFERENCE -> fail("entities cannot be read")
                else -> Unit
            }
        }
    }

    private fun step(): Int {
        val event = guarded { xml.next() }
        line = maxOf(xml.location.lineNumber, 1)
        column = maxOf(xml.location.columnNumber, 1)
        return event
    }

    private fun <T> guarded(work: () -> T): T {
        try {
            return work()
        } catch (e: XMLStreamException) {
            val place = e.location
            throw FileFormatException(source, maxOf(place?.lineNumber ?: line, 1), maxOf(place?.columnNumber ?: 0, 0), reason(e), e)
        } catch (e: RuntimeException) {
            // The parser of the JDK throws others as well at some broken texts.
            throw FileFormatException(source, line, column, "this is not well-formed XML", e)
        }
    }

    private fun reason(e: XMLStreamException): String {
        val message = e.message.orEmpty().substringAfter("Message: ").ifBlank { "this is not well-formed XML" }
        return "this is not well-formed XML: " + message.lines().joinToString(" ").trim()
    }

    override fun fail(reason: String): Nothing = throw FileFormatException(source, line, column, reason)

    /** A complaint about the place that is reached now, for later. */
    fun placed(): Complaint {
        val thenLine = line
        val thenColumn = column
        return Complaint { throw FileFormatException(source, thenLine, thenColumn, it) }
    }

    private companion object {
        const val MAX_DEPTH = 200

        fun factory(): XMLInputFactory = XMLInputFactory.newDefaultFactory().apply {
            setProperty(XMLInputFactory.SUPPORT_DTD, false)
            setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false)
            setProperty(XMLInputFactory.IS_REPLACING_ENTITY_REFERENCES, false)
        }
    }
}
