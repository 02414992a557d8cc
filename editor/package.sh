#!/bin/sh
# Makes an installable editor with a Java runtime of its own, in editor/target/package.
#
#   editor/package.sh          an image: a folder that runs wherever it is put
#   editor/package.sh deb      a package of Debian and Ubuntu, with a menu entry and projects that open by a double click
#   editor/package.sh TYPE     what else the jpackage of this system makes: rpm, msi, exe, dmg, pkg
#
# Needs a JDK 17 or newer with jpackage, and Maven where the editor is not built yet; for deb also dpkg-deb and fakeroot.
set -eu
cd "$(dirname "$0")"
type=${1:-app-image}
source=src/package
target=target/package

fail() {
    printf 'package.sh: %s\n' "$1" >&2
    exit 1
}

if [ -n "${JAVA_HOME:-}" ]; then jpackage=$JAVA_HOME/bin/jpackage; else jpackage=jpackage; fi
command -v "$jpackage" >/dev/null || fail "no jpackage found; set JAVA_HOME to a JDK 17 or newer"

jar_of() { for jar in target/trigrid-editor-*.jar; do
    case $jar in *-sources.jar | *-javadoc.jar) ;; *) printf '%s\n' "$jar" ;; esac
done; }

jar=$(jar_of)
if [ ! -f "$jar" ] || [ ! -d target/mods ] || [ ! -d target/lib ]; then
    (cd .. && mvn -q -B -ntp -Dmaven.test.skip=true -pl editor -am package)
    jar=$(jar_of)
fi

# Installers want numbers alone.
version=$(basename "$jar" .jar)
version=${version#trigrid-editor-}
version=${version%%-*}

case $type in
    app-image) rm -rf "$target/trigrid-editor" "$target/trigrid-editor.app" ;;
    *) rm -f "$target"/*."$type" ;;
esac
rm -rf "$target/input"
mkdir -p "$target/input"
cp "$jar" "$target/input"
cp -R target/lib "$target/input/lib"

icon=src/main/resources/org/trigrid/editor/app/icon.png
case $(uname -s) in
    Darwin)
        icon=$source/icon.icns
        # The first number of a version of macOS must not be 0.
        case $version in 0.*) version=1.${version#0.} ;; esac
        ;;
    MINGW* | MSYS* | CYGWIN*) icon=$source/icon.ico ;;
esac

set -- --type "$type" --dest "$target" --name trigrid-editor --app-version "$version" --vendor TriGrid \
    --description 'Draws and meshes 2D domains' --copyright 'Licensed under Apache-2.0' --icon "$icon" \
    --input "$target/input" --main-jar "$(basename "$jar")" --main-class org.trigrid.editor.Main \
    --module-path target/mods --add-modules javafx.controls,java.desktop,jdk.unsupported \
    --jlink-options '--strip-debug --no-header-files --no-man-pages --strip-native-commands'
if [ "$type" != app-image ]; then
    set -- "$@" --file-associations "$source/project.properties" --license-file ../LICENSE
fi
case $type in
    deb | rpm)
        set -- "$@" --resource-dir "$source" --linux-package-name trigrid-editor --linux-shortcut --linux-menu-group 'Science;Math;'
        # JavaFX loads these by itself, which jpackage does not see.
        [ "$type" = rpm ] || set -- "$@" --linux-package-deps 'libgtk-3-0, libgl1, libxxf86vm1'
        ;;
    msi | exe) set -- "$@" --win-menu --win-shortcut ;;
esac
"$jpackage" "$@"
rm -rf "$target/input"
ls -d "$target"/*
