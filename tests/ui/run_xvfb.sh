#!/bin/sh
# usage: run_xvfb.sh PROGRAM [ARGUMENTS]: runs it on an X server and a window manager of its own, and gives its exit status.
# Windows become active only under a window manager, so shortcuts and docks need one. Ends what it started.
command -v Xvfb >/dev/null || { echo "run_xvfb.sh: Xvfb is missing: apt install xvfb openbox" >&2; exit 1; }
work=$(mktemp -d)
mkfifo "$work/display"
Xvfb -displayfd 3 -screen 0 "${MESHWRIGHT_TEST_SCREEN:-1700x1100x24}" -nolisten tcp 3>"$work/display" >/dev/null 2>&1 &
server=$!
read -r number <"$work/display"
export DISPLAY=":$number"
export XDG_RUNTIME_DIR="$work/run" XDG_CONFIG_HOME="$work/config" XDG_CACHE_HOME="${XDG_CACHE_HOME:-$HOME/.cache}"
mkdir -m 700 "$XDG_RUNTIME_DIR" "$XDG_CONFIG_HOME"
manager=
if command -v openbox >/dev/null; then
    openbox >/dev/null 2>&1 &
    manager=$!
    sleep 0.5
fi
"$@"
status=$?
[ -n "$manager" ] && kill "$manager" 2>/dev/null
kill "$server" 2>/dev/null
wait "$server" 2>/dev/null
rm -rf "$work"
exit $status
