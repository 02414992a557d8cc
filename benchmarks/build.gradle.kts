plugins {
    alias(libs.plugins.kotlin.jvm)
    application
}

dependencies {
    implementation(project(":core"))
    implementation(project(":cli"))
    implementation(libs.kotlin.stdlib)
    implementation(libs.jmh.core)
    annotationProcessor(libs.jmh.annprocess)

    testImplementation(libs.junit.jupiter)
    testRuntimeOnly(libs.junit.platform.launcher)
}

application {
    mainClass.set("org.openjdk.jmh.Main")
}
