# tests/run and demos/run source this file, with `root` set to the top folder: functions that install missing packages and
# build a preset.

# install_missing [LIST...]: installs the packages of cmake/packages.txt, and of the other LISTs in cmake/, that the machine
# lacks. If they cannot be installed, it prints one message and exits with code 2.
install_missing() {
    local package list missing=() as_root=()
    while read -r package; do
        case "$package" in '' | '#'*) continue ;; esac
        if ! command -v dpkg-query >/dev/null ||
            [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
            missing+=("$package")
        fi
    done < <(for list in packages.txt "$@"; do cat "$root/cmake/$list"; done)
    [ ${#missing[@]} -eq 0 ] && return

    if [ "$(id -u)" -ne 0 ]; then as_root=(sudo); fi
    if ! command -v apt-get >/dev/null || { [ "$(id -u)" -ne 0 ] && ! sudo -n true 2>/dev/null && [ ! -t 0 ]; } ||
        { [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; }; then
        echo "clearway: these packages are missing and need apt-get and root (or sudo) to install: ${missing[*]}" >&2
        exit 2
    fi
    if [ ${#as_root[@]} -gt 0 ] && ! sudo -n true 2>/dev/null; then sudo -v; fi # asks for the password on a line of its own
    show "installing ${#missing[@]} packages"
    local log
    log=$(mktemp)
    if ! { "${as_root[@]}" apt-get update -q &&
        "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"; } \
        >"$log" 2>&1; then
        show ""
        cat "$log" >&2
        rm -f "$log"
        echo "clearway: apt-get could not install: ${missing[*]}" >&2
        exit 2
    fi
    rm -f "$log"
    show ""
}

# show TEXT: tells on stderr what is going on, in one line that the next call overwrites; "" takes the line away. Without a terminal, or with
# CI set, each text is a line of its own.
show() {
    if is_shown_in_place; then
        printf '\r\033[K%s' "$1" >&2
    elif [ -n "$1" ]; then
        echo "$1" >&2
    fi
}

is_shown_in_place() {
    [ -t 2 ] && [ -z "${CI:-}" ]
}

# build_preset PRESET [TARGET...]: configures the preset and builds the targets, by default all of them. What CMake and the compiler say is
# shown only when they fail.
build_preset() {
    local preset=$1 log status=0 line
    shift
    log=$(mktemp)
    show "configuring"
    (cd "$root" && cmake --preset "$preset" -Wno-dev --log-level=WARNING) >"$log" 2>&1 || status=$?
    if [ $status = 0 ]; then
        show "building"
        (cd "$root" && cmake --build --preset "$preset" ${1:+--target "$@"} 2>&1) | while IFS= read -r line || [ -n "$line" ]; do
            printf '%s\n' "$line"
            if is_shown_in_place && [[ "$line" =~ ^\[([0-9]+)/([0-9]+)\] ]]; then
                show "building ${BASH_REMATCH[1]} of ${BASH_REMATCH[2]}"
            fi
        done >"$log" || status=$?
    fi
    show ""
    if [ $status != 0 ]; then
        grep -vE '^\[[0-9]+/[0-9]+\] (Building|Linking|Generating)' "$log" >&2 || cat "$log" >&2
        echo "clearway: the preset $preset could not be built" >&2
    fi
    rm -f "$log"
    return $status
}
