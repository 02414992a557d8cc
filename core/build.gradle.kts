plugins {
    alias(libs.plugins.kotlin.jvm)
    alias(libs.plugins.kotlin.serialization)
    alias(libs.plugins.dokka)
    `java-library`
}

// `./gradlew :core:dokkaGenerate` writes the API pages, with lines of the samples, to build/dokka.
dokka {
    moduleName.set("trigrid-core")
    dokkaSourceSets.main {
        includes.from("module.md")
        samples.from("../samples/src/main/kotlin")
    }
}

kotlin {
    explicitApi()
}

dependencies {
    api(libs.kotlin.stdlib)
    implementation(libs.kotlinx.serialization.core)
    implementation(libs.kotlinx.serialization.json)
    api(libs.jts.core)
    implementation(libs.jts.io.common)
    api(libs.ejml.ddense)
    api(libs.ejml.dsparse)

    testImplementation(libs.junit.jupiter)
    testImplementation(libs.archunit)
    testImplementation(libs.kotlin.metadata)
    testRuntimeOnly(libs.junit.platform.launcher)
}
