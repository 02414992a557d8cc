import org.jetbrains.kotlin.gradle.dsl.JvmTarget
import org.jetbrains.kotlin.gradle.dsl.KotlinJvmProjectExtension

plugins {
    alias(libs.plugins.kotlin.jvm) apply false
    alias(libs.plugins.kotlin.serialization) apply false
    alias(libs.plugins.dokka) apply false
    alias(libs.plugins.dokka.javadoc) apply false
}

allprojects {
    group = "org.trigrid"
    version = "0.1.0-SNAPSHOT"
}

// Tags left out of an ordinary test run; -PexcludedGroups= runs everything.
val excludedGroups: String = providers.gradleProperty("excludedGroups").getOrElse("corpus")

subprojects {
    plugins.withId("org.jetbrains.kotlin.jvm") {
        pluginManager.apply("maven-publish")

        // Any JDK from 17 builds the same class files, so no toolchain is asked for.
        extensions.configure<JavaPluginExtension> {
            sourceCompatibility = JavaVersion.VERSION_17
            targetCompatibility = JavaVersion.VERSION_17
            withSourcesJar()
        }
        extensions.configure<KotlinJvmProjectExtension> {
            compilerOptions {
                jvmTarget.set(JvmTarget.JVM_17)
                allWarningsAsErrors.set(true)
                freeCompilerArgs.addAll(
                    "-Xno-param-assertions",
                    "-Xno-call-assertions",
                    "-Xno-receiver-assertions",
                    "-Xstring-concat=inline",
                )
            }
        }
        // Nobody needs the others as a library.
        if (name in setOf("core", "cli", "editor", "spark")) publishWithApiPages()
    }

    tasks.withType<JavaCompile>().configureEach {
        options.encoding = "UTF-8"
        options.release.set(17)
    }
    tasks.withType<Test>().configureEach {
        useJUnitPlatform {
            if (excludedGroups.isNotEmpty()) excludeTags(excludedGroups)
        }
        maxHeapSize = "2g"
    }
    tasks.withType<Jar>().configureEach {
        archiveBaseName.set("trigrid-${project.name}")
        isPreserveFileTimestamps = false
        isReproducibleFileOrder = true
        manifest.attributes("Implementation-Title" to "trigrid-${project.name}", "Implementation-Version" to project.version)
    }
}

// `./gradlew publishAllPublicationsToFolderRepository` publishes the jars with sources and API pages to build/repository.
fun Project.publishWithApiPages() {
    pluginManager.apply("maven-publish")
    pluginManager.apply("org.jetbrains.dokka-javadoc")
    val apiPages = tasks.register<Jar>("apiPagesJar") {
        archiveClassifier.set("javadoc")
        from(tasks.named("dokkaGeneratePublicationJavadoc"))
    }
    extensions.configure<PublishingExtension> {
        publications {
            create<MavenPublication>("maven") {
                from(components["java"])
                artifact(apiPages)
                artifactId = "trigrid-${project.name}"
            }
        }
        repositories {
            maven {
                name = "folder"
                url = uri(rootProject.layout.buildDirectory.dir("repository"))
            }
        }
    }
}
