plugins {
    alias(libs.plugins.kotlin.jvm)
    `java-library`
}

kotlin {
    explicitApi()
}

dependencies {
    api(project(":core"))
    implementation(project(":cli"))
    implementation(libs.kotlin.stdlib)
    implementation(libs.picocli)
    compileOnly(libs.spark.sql)

    testImplementation(libs.junit.jupiter)
    testRuntimeOnly(libs.junit.platform.launcher)
}

// Every cluster has its own Spark; only the tests bring one.
configurations.named("testImplementation") {
    extendsFrom(configurations.getByName("compileOnly"))
}

// Spark asks for these of every JVM that it runs in; spark-submit gives them itself.
tasks.named<Test>("test") {
    val opened = listOf(
        "java.base/java.lang",
        "java.base/java.lang.invoke",
        "java.base/java.lang.reflect",
        "java.base/java.io",
        "java.base/java.net",
        "java.base/java.nio",
        "java.base/java.util",
        "java.base/java.util.concurrent",
        "java.base/java.util.concurrent.atomic",
        "java.base/jdk.internal.ref",
        "java.base/sun.nio.ch",
        "java.base/sun.nio.cs",
        "java.base/sun.security.action",
        "java.base/sun.util.calendar",
    )
    jvmArgs(opened.map { "--add-opens=$it=ALL-UNNAMED" })
}

// build/libs/trigrid-spark-job.jar: all that spark-submit needs. Maven's gives libraries that clusters may have other names.
tasks.register<Jar>("jobJar") {
    archiveFileName.set("trigrid-spark-job.jar")
    duplicatesStrategy = DuplicatesStrategy.EXCLUDE
    manifest.attributes("Main-Class" to "org.trigrid.spark.job.TriGridJob")
    from(sourceSets.main.get().output)
    from(configurations.runtimeClasspath.map { path -> path.map { if (it.isDirectory) it else zipTree(it) } })
    exclude("META-INF/*.SF", "META-INF/*.DSA", "META-INF/*.RSA", "META-INF/versions/9/module-info.class", "module-info.class")
}

tasks.named("assemble") {
    dependsOn("jobJar")
}
