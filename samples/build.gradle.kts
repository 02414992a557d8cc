plugins {
    alias(libs.plugins.kotlin.jvm)
    application
}

dependencies {
    implementation(project(":core"))
    implementation(libs.kotlin.stdlib)

    testImplementation(libs.junit.jupiter)
    testRuntimeOnly(libs.junit.platform.launcher)
}

// Another sample: -Psample=org.trigrid.samples.PlateWithHole
application {
    mainClass.set("org.trigrid.samples.PoissonOnHand")
    providers.gradleProperty("sample").orNull?.let { mainClass.set(it) }
}

tasks.named<JavaExec>("run") {
    workingDir = rootDir
}
