plugins {
    alias(libs.plugins.kotlin.jvm)
    application
}

// JavaFX comes as one jar per platform, named by a classifier.
val javafxPlatform: String = run {
    val os = System.getProperty("os.name").lowercase()
    val arm = System.getProperty("os.arch") in setOf("aarch64", "arm64")
    when {
        os.contains("win") -> "win"
        os.contains("mac") -> if (arm) "mac-aarch64" else "mac"
        else -> if (arm) "linux-aarch64" else "linux"
    }
}
val javafxVersion: String = libs.versions.javafx.get()

dependencies {
    implementation(project(":core"))
    implementation(libs.kotlin.stdlib)
    implementation("${libs.javafx.base.get().module}:$javafxVersion:$javafxPlatform")
    implementation("${libs.javafx.graphics.get().module}:$javafxVersion:$javafxPlatform")
    implementation("${libs.javafx.controls.get().module}:$javafxVersion:$javafxPlatform")
    implementation(libs.atlantafx.base)

    testImplementation(libs.junit.jupiter)
    testImplementation(libs.archunit)
    testImplementation(libs.testfx.core)
    testImplementation(libs.testfx.junit)
    testRuntimeOnly(libs.junit.platform.launcher)
}

application {
    applicationName = "trigrid-editor"
    mainClass.set("org.trigrid.editor.Main")
}

// JavaFX warns when it is started from the class path, so its jars go on the module path.
tasks.named<JavaExec>("run") {
    val runtime = sourceSets.main.get().runtimeClasspath
    val javafx = runtime.filter { it.name.startsWith("javafx-") }
    classpath = runtime.filter { !it.name.startsWith("javafx-") }
    jvmArgumentProviders.add(
        CommandLineArgumentProvider {
            listOf("--module-path", javafx.asPath, "--add-modules", "javafx.controls")
        },
    )
}

// The paper's cases are the gallery of the welcome.
tasks.named<ProcessResources>("processResources") {
    from("../src-test-data/paper") {
        include("*.trigrid.json")
        into("org/trigrid/editor/gallery")
    }
}

tasks.named<Test>("test") {
    // Window tests press keys through JavaFX's own robot and draw without a graphics card.
    systemProperty("testfx.robot", "glass")
    systemProperty("prism.order", "sw")
}

// Whoever uses the editor as a library gets JavaFX for their own platform, by the POMs of JavaFX.
extensions.configure<PublishingExtension> {
    publications.withType<MavenPublication>().configureEach {
        pom.withXml {
            val classifiers = asElement().getElementsByTagName("classifier")
            while (classifiers.length > 0) classifiers.item(0).let { it.parentNode.removeChild(it) }
        }
    }
}
