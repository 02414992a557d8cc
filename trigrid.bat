@echo off
rem Runs TriGrid from a checkout: builds it with Maven on first use, then starts the command line,
rem or the editor for "trigrid edit". After a change of the sources: trigrid --rebuild ...
rem
rem TRIGRID_JAVA_OPTS   more options for the JVM, for instance -Xmx8g
setlocal enableextensions disabledelayedexpansion
set "HOME_DIR=%~dp0"

if defined JAVA_HOME (
    set "JAVA=%JAVA_HOME%\bin\java.exe"
) else (
    set "JAVA=java.exe"
)
"%JAVA%" -version >nul 2>&1
if errorlevel 1 (
    echo trigrid: no Java found; install a JDK 17 or newer and set JAVA_HOME to it 1>&2
    exit /b 4
)

set "REBUILD="
if /i "%~1"=="--rebuild" (
    set "REBUILD=1"
    shift /1
)

rem "shift" does not change %%*, so the arguments are gathered one by one.
set "MODULE=cli"
set "ARGUMENTS="
if /i not "%~1"=="edit" goto gather
set "MODULE=editor"
shift /1
:gather
if "%~1"=="" if [%1]==[] goto gathered
if "%MODULE%"=="editor" if "%~1"=="--help" goto edithelp
if "%MODULE%"=="editor" if "%~1"=="-h" goto edithelp
set ARGUMENTS=%ARGUMENTS% %1
shift /1
goto gather
:edithelp
set "MODULE=cli"
set "ARGUMENTS=edit --help"
:gathered

set "TARGET=%HOME_DIR%%MODULE%\target"
if defined REBUILD goto build
if not exist "%TARGET%\launcher.stamp" goto build
goto start

:build
where mvn >nul 2>&1
if errorlevel 1 (
    echo trigrid: no Maven found, which the first build needs; install it and put its bin folder on the PATH 1>&2
    exit /b 4
)
"%JAVA%" --list-modules 2>nul | findstr /b "jdk.compiler" >nul
if errorlevel 1 (
    echo trigrid: the Java found has no compiler or is older than 17; install a JDK 17 or newer and set JAVA_HOME to it 1>&2
    exit /b 4
)
echo trigrid: building, which takes a minute the first time ... 1>&2
if not exist "%TARGET%" mkdir "%TARGET%"
if exist "%TARGET%\launcher.stamp" del "%TARGET%\launcher.stamp"
if exist "%TARGET%\trigrid-%MODULE%-*.jar" del "%TARGET%\trigrid-%MODULE%-*.jar"
pushd "%HOME_DIR%"
call mvn -q -B -ntp -Dmaven.test.skip=true -pl %MODULE% -am package > "%TARGET%\launcher.log" 2>&1
if errorlevel 1 (
    popd
    type "%TARGET%\launcher.log" 1>&2
    echo trigrid: the build failed; what Maven said is above and in %TARGET%\launcher.log 1>&2
    exit /b 4
)
popd
echo built> "%TARGET%\launcher.stamp"

:start
for %%J in ("%TARGET%\trigrid-%MODULE%-*.jar") do set "JAR=%%~fJ"
if "%MODULE%"=="editor" goto editor
"%JAVA%" -XX:+UseSerialGC -Xshare:auto %TRIGRID_JAVA_OPTS% -jar "%JAR%" %ARGUMENTS%
exit /b %ERRORLEVEL%

:editor
"%JAVA%" %TRIGRID_JAVA_OPTS% --module-path "%TARGET%\mods" --add-modules javafx.controls -cp "%JAR%" org.trigrid.editor.Main %ARGUMENTS%
exit /b %ERRORLEVEL%
