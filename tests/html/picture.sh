#!/bin/sh
# Draws docs/figures/report.png anew: the page of the built-in report, around its first failing equation.
# Usage: CHROMIUM=/path/to/chromium tests/html/picture.sh
set -e
cd "$(dirname "$0")/../.."
page=$(mktemp -d)
trap 'rm -rf "$page"' EXIT
cargo run --quiet -- report -o "$page/report.html" || test $? -eq 1
"${CHROMIUM:-chromium}" --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size=1100,1000 \
  --screenshot="$PWD/docs/figures/report.png" "file://$page/report.html"
