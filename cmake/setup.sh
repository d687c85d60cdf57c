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
    echo "Installing: ${missing[*]}"
    local log
    log=$(mktemp)
    if ! { "${as_root[@]}" apt-get update -q &&
        "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"; } \
        >"$log" 2>&1; then
        cat "$log" >&2
        rm -f "$log"
        echo "clearway: apt-get could not install: ${missing[*]}" >&2
        exit 2
    fi
    rm -f "$log"
}

# build_preset PRESET [TARGET...]: configures the preset and builds the targets, by default all of them.
build_preset() {
    local preset=$1
    shift
    (cd "$root" && cmake --preset "$preset" -Wno-dev --log-level=WARNING >/dev/null &&
        cmake --build --preset "$preset" ${1:+--target "$@"})
}
