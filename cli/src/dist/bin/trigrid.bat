@echo off
rem Runs the command line of TriGrid from where it was unpacked.
rem
rem TRIGRID_JAVA_OPTS   more options for the JVM, for instance -Xmx8g
setlocal enableextensions disabledelayedexpansion
if defined JAVA_HOME (
    set "JAVA=%JAVA_HOME%\bin\java.exe"
) else (
    set "JAVA=java.exe"
)
"%JAVA%" -version >nul 2>&1
if errorlevel 1 (
    echo trigrid: no Java found; install Java 17 or newer and set JAVA_HOME to it 1>&2
    exit /b 4
)
"%JAVA%" -XX:+UseSerialGC -Xshare:auto %TRIGRID_JAVA_OPTS% -cp "%~dp0..\lib\*" org.trigrid.cli.Main %*
exit /b %ERRORLEVEL%
