plugins {
    alias(libs.plugins.kotlin.jvm)
    application
}

dependencies {
    implementation(project(":core"))
    implementation(libs.kotlin.stdlib)
    implementation(libs.kotlinx.serialization.core)
    implementation(libs.kotlinx.serialization.json)
    implementation(libs.picocli)

    testImplementation(libs.junit.jupiter)
    testRuntimeOnly(libs.junit.platform.launcher)
}

application {
    applicationName = "trigrid"
    mainClass.set("org.trigrid.cli.Main")
}

// The scripts are those of src/dist, in both builds.
tasks.named("startScripts") {
    enabled = false
}

// Completion and the manual page, which the program prints itself.
val printed = mapOf(
    "completion/trigrid.bash" to listOf("completion", "bash"),
    "completion/trigrid.zsh" to listOf("completion", "zsh"),
    "completion/trigrid.fish" to listOf("completion", "fish"),
    "man/trigrid.1" to listOf("man"),
)
val prints = printed.map { (file, words) ->
    tasks.register<JavaExec>("print-" + words.joinToString("-")) {
        val target = layout.buildDirectory.file("printed/$file")
        classpath(tasks.named("jar"), configurations.named("runtimeClasspath"))
        mainClass.set(application.mainClass)
        args(words)
        outputs.file(target)
        doFirst { standardOutput = target.get().asFile.outputStream() }
    }
}

distributions {
    main {
        distributionBaseName.set("trigrid-cli")
        contents {
            from("../LICENSE")
            from(files(layout.buildDirectory.dir("printed")).builtBy(prints))
        }
    }
}
