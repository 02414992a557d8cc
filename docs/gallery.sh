#!/bin/sh
# Draws the pictures of docs/gallery.md and writes its table of figures anew; its output depends on the sources alone.
set -eu
cd "$(dirname "$0")/.."
cases='small-grid general general-edited machine-part machine-part-dense machine-part-thinner owen bastian hand'
pictures=docs/pictures
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Built before anything is taken away.
./trigrid --version >/dev/null

# What the paper says of a case: figure, nodes, elements, bandwidth before and after; - where it says nothing.
paper() {
    case $1 in
        small-grid) echo '7 26 34 - 13' ;;
        general) echo '8(a,b) - - - -' ;;
        general-edited) echo '8(c) - - - -' ;;
        machine-part) echo '9(a,b) 563 966 - -' ;;
        machine-part-dense) echo '9(c,d) 1445 2585 - -' ;;
        machine-part-thinner) echo '9(e,f) 1198 2104 2181 87' ;;
        owen) echo '10 - - - -' ;;
        bastian) echo '11 - - - -' ;;
        hand) echo '12 - - - -' ;;
    esac
}

draw() { # case, strategy, what to show, picture
    ./trigrid picture "src-test-data/paper/$1.trigrid.json" --strategy "$2" --show "$3" -o "$pictures/$4.svg"
}

row() { # case, strategy
    ./trigrid mesh "src-test-data/paper/$1.trigrid.json" --strategy "$2" -o "$work/mesh.msh" --report "$work/report.json" >"$work/said"
    # shellcheck disable=SC2046
    set -- "$1" "$2" $(paper "$1")
    awk -v name="$1" -v strategy="$2" -v figure="$3" -v nodes="$4" -v elements="$5" -v before="$6" -v after="$7" '
        function beside(ours, theirs) { return theirs == "-" ? ours : ours " / " theirs }
        {
            gsub(/[",]/, ""); sub(/:/, "")
            if ($2 == "{") { group = $1 "."; next }
            if ($1 == "}") { group = ""; next }
            if (NF == 2) value[group $1] = $2
        }
        END {
            printf "| [%s](#%s) | %s | %s | %d | %s | %s | %.1f° | %.3f | %.3f | %d | %s | %s |\n",
                name, name, figure, strategy, value["boundaryNodes"],
                beside(value["nodes"], nodes), beside(value["elements"], elements), value["quality.minAngle"],
                value["quality.min"], value["quality.mean"], value["fallbacks"],
                beside(value["bandwidth.before"], before), beside(value["bandwidth.after"], after)
        }' "$work/report.json"
}

mkdir -p "$pictures"
rm -f "$pictures"/*.svg
for name in $cases; do
    draw "$name" robust domain "$name-domain"
    [ "$name" = general-edited ] || draw "$name" robust matrix "$name-matrix"
    case $name in
        small-grid) draw "$name" robust numbers "$name-numbers" ;;
        *)
            draw "$name" robust mesh "$name"
            draw "$name" robust quality "$name-quality"
            ;;
    esac
done
./trigrid picture src-test-data/paper/small-grid.trigrid.json --no-renumber --show numbers -o "$pictures/small-grid-made.svg"
./trigrid picture src-test-data/regions/stator-slot.trigrid.json -o "$pictures/stator-slot.svg"
for name in machine-part hand; do draw "$name" classic quality "$name-classic"; done

{
    echo '| case | figure | strategy | boundary nodes | nodes / paper | elements / paper | smallest angle | smallest q | mean q | fallbacks | bandwidth as made / paper | renumbered / paper |'
    echo '| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |'
    for name in $cases; do
        for strategy in robust classic; do row "$name" "$strategy"; done
    done
} >"$work/table"
awk -v table="$work/table" '
    /^<!-- figures end -->/ { inside = 0 }
    !inside { print }
    /^<!-- figures begin -->/ { inside = 1; print ""; while ((getline line < table) > 0) print line; print "" }
' docs/gallery.md >"$work/gallery.md"
cat "$work/gallery.md" >docs/gallery.md
