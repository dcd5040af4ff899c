#!/usr/bin/env bash
# raylab site: a web site of the tree's Markdown pages, which can be searched and read without a server.
#
# It is made by mkdocs-material, which pip installs once into a virtual environment in build/site-tools, in the versions
# of cmake/site/requirements.txt.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
fail() { printf 'raylab: site: %s\n' "$2" >&2; exit "$1"; }

output=$root/out/site
options=()
while [ $# -gt 0 ]; do
    case $1 in
        -h | --help)
            cat <<'HELP'
./raylab site [-o DIR] [--with-answers]
  Makes a web site of all pages: guides, handouts, reference. Open DIR/index.html; it needs no server. A link that
  leads nowhere is an error. Needs Python 3.9 or newer with its module venv, and PyPI for the first call.
  -o DIR            the folder to write (default out/site); a site that is there is replaced
  --with-answers    also the answers to the handouts' questions, for instructors
Examples:
  ./raylab site
  ./raylab site -o /var/www/raylab
HELP
            exit 0 ;;
        -o) [ $# -ge 2 ] || fail 2 "-o needs a folder; see ./raylab site --help"
            output=$2; shift 2 ;;
        --with-answers) options+=("$1"); shift ;;
        *) fail 2 "'$1' is not an option; see ./raylab site --help" ;;
    esac
done
case $output in /*) ;; *) output=$PWD/$output ;; esac
if [ -e "$output" ] && [ ! -f "$output/sitemap.xml" ]; then
    fail 2 "$output is there, and is no site: remove it, or choose another folder with -o"
fi

# Installed as asked for, or anew.
tools=$root/build/site-tools
wanted=$root/cmake/site/requirements.txt
if ! cmp -s "$wanted" "$tools/installed.txt"; then
    command -v python3 >/dev/null || fail 2 "needs python3, and it is not here"
    echo "installing mkdocs-material into build/site-tools" >&2
    rm -rf -- "$tools"
    python3 -m venv "$tools" >&2 ||
        fail 2 "python3 cannot make a virtual environment; on Debian and Ubuntu: apt-get install python3-venv"
    "$tools/bin/pip" install -q --disable-pip-version-check -r "$wanted" >&2 ||
        fail 3 "pip could not install what cmake/site/requirements.txt names"
    cp -- "$wanted" "$tools/installed.txt"
fi

pages=$root/build/site-pages
"$tools/bin/python" -B "$root/cmake/site/stage.py" "$root" "$pages" ${options[@]+"${options[@]}"}
# The new site takes the old one's place when it is whole.
new=$output.new
trap 'rm -rf -- "$new"' EXIT
mkdir -p "$(dirname -- "$output")"
# Not --quiet: that would hide warnings from --strict, too.
log=$root/build/site.log
(cd "$pages" && NO_MKDOCS_2_WARNING=1 "$tools/bin/python" -B -m mkdocs build --strict -d "$new") >"$log" 2>&1 || {
    grep -v '^INFO' "$log" >&2
    fail 1 "the site was not made; the messages above name page and link (log: build/site.log)"
}
rm -rf -- "$output"
mv -- "$new" "$output"
echo "$output/index.html"
