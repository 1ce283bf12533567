# shellcheck shell=bash
# The packages that the project needs, and their installation.

# Group; how the package is found (a command, a header, a Python module, a Coq library, or a file); its names for apt, dnf and brew.
readonly package_table='
build command:c++                         g++                 gcc-c++             gcc
build command:cmake                       cmake               cmake               cmake
build command:ninja                       ninja-build         ninja-build         ninja
build command:flock                       util-linux          util-linux          flock
build header:boost/multiprecision/gmp.hpp libboost-dev        boost-devel         boost
build header:gmp.h                        libgmp-dev          gmp-devel           gmp
build header:CLI/CLI.hpp                  libcli11-dev        cli11-devel         cli11
build header:fmt/format.h                 libfmt-dev          fmt-devel           fmt
test  header:nlohmann/json.hpp            nlohmann-json3-dev  json-devel          nlohmann-json
build header:pugixml.hpp                  libpugixml-dev      pugixml-devel       pugixml
test  header:catch2/*.hpp                 catch2              catch-devel         catch2
test  header:gtest/gtest.h                libgtest-dev        gtest-devel         googletest
test  header:eigen3/Eigen/Core            libeigen3-dev       eigen3-devel        eigen
test  header:gsl/gsl_bspline.h            libgsl-dev          gsl-devel           gsl
test  command:pkg-config                  pkg-config          pkgconf-pkg-config  pkgconf
test  command:python3                     python3             python3             python
test  header:pybind11/pybind11.h          pybind11-dev        pybind11-devel      pybind11
test  header:python3*/Python.h            python3-dev         python3-devel       python
test  python:pytest                       python3-pytest      python3-pytest      python-pytest
test  python:hypothesis                   python3-hypothesis  python3-hypothesis  python-hypothesis
test  python:numpy                        python3-numpy       python3-numpy       numpy
test  python:scipy                        python3-scipy       python3-scipy       scipy
test  python:sympy                        python3-sympy       python3-sympy       sympy
wheel header:pybind11/pybind11.h          pybind11-dev        pybind11-devel      pybind11
wheel header:python3*/Python.h            python3-dev         python3-devel       python
wheel python:pip                          python3-pip         python3-pip         python
wheel python:setuptools                   python3-setuptools  python3-setuptools  python-setuptools
wheel python:ensurepip                    python3-venv        python3             python
wheel python:wheel                        python3-wheel       python3-wheel       python
browser command:python3                   python3             python3             python
browser command:chromium                  chromium            chromium            chromium
latex command:pdflatex                    texlive-latex-recommended texlive-latex mactex-no-gui
latex file:/usr/share/texlive/texmf-dist/tex/latex/pgf/frontendlayer/tikz.sty texlive-pictures texlive-pgf mactex-no-gui
latex file:/usr/share/texmf/tex/latex/lm/lmodern.sty lmodern texlive-lm mactex-no-gui
latex command:pdftoppm                    poppler-utils       poppler-utils       poppler
bench header:flint/fmpq.h                libflint-dev        flint-devel         flint
bench command:gp                          pari-gp             pari-gp             pari
bench header:simdjson.h                libsimdjson-dev     simdjson-devel      simdjson
bench command:valgrind                   valgrind            valgrind            valgrind
bench python:sympy                        python3-sympy       python3-sympy       sympy
package command:dpkg-buildpackage         dpkg-dev            dpkg-dev            dpkg
package command:dh                        debhelper           debhelper           debhelper
package command:lintian                   lintian             lintian             lintian
package command:help2man                  help2man            help2man            help2man
ci    command:ccache                      ccache              ccache              ccache
ci    command:clang++-19                  clang-19            clang               llvm@19
ci    command:clang-format-19             clang-format-19     clang-tools-extra   llvm@19
ci    command:clang-tidy-19               clang-tidy-19       clang-tools-extra   llvm@19
ci    file:/usr/lib/llvm-19/lib/clang/19/lib/linux/libclang_rt.fuzzer-*.a libclang-rt-19-dev compiler-rt llvm@19
proofs command:coqc                       coq                 coq                 coq
proofs coq:mathcomp/algebra               libcoq-mathcomp-algebra coq             coq
proofs coq:SsrMultinomials                libcoq-mathcomp-multinomials coq        coq
ci    command:shellcheck                  shellcheck          ShellCheck          shellcheck
ci    python:jsonschema                   python3-jsonschema  python3-jsonschema  python-jsonschema
'

# The exit status if packages are missing and this script may not install them (EX_UNAVAILABLE of sysexits.h).
readonly exit_unavailable=69

is_present() {
  local kind=${1%%:*} name=${1#*:} directory
  case $kind in
    command) command -v "$name" >/dev/null ;;
    coq) command -v coqc >/dev/null && [[ -d $(coqc -where)/user-contrib/$name ]] ;;
    file) compgen -G "$name" >/dev/null ;;
    python)
      # Scripts and tests run the Python for which the system installs packages, if there is one.
      "$(type -P /usr/bin/python3 || type -P python3)" -c "import $name" 2>/dev/null
      ;;
    header)
      local -a directories=(/usr/include /usr/include/*-linux-gnu /usr/local/include /opt/homebrew/include)
      local -a path
      IFS=: read -r -a path <<<"${CPATH:-}:${CPLUS_INCLUDE_PATH:-}"
      for directory in "${directories[@]}" ${path[@]+"${path[@]}"}; do
        compgen -G "$directory/$name" >/dev/null && return
      done
      return 1
      ;;
  esac
}

# missing_packages "GROUP..." apt|dnf|brew: the packages to install, each once, on one line.
missing_packages() {
  local column line
  local -a row
  case $2 in apt) column=2 ;; dnf) column=3 ;; brew) column=4 ;; esac
  while read -r line; do
    read -r -a row <<<"$line"
    if [[ -n $line && " $1 " == *" ${row[0]} "* ]] && ! is_present "${row[1]}"; then
      echo "${row[column]}"
    fi
  done <<<"$package_table" | sort -u | xargs
}

install_with_apt() {
  local attempt
  for attempt in 1 2; do
    if apt-get -q update &&
      DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends \
        -o DPkg::Lock::Timeout=300 install "$@"; then
      return
    fi
    echo "apt-get failed (attempt $attempt of 2)"
  done
  return 1
}

# require_packages "GROUP...": installs missing packages, or lists them and exits.
require_packages() {
  local missing log
  missing=$(missing_packages "$1" apt)
  [[ -z $missing ]] && return
  if [[ $EUID -ne 0 ]] || ! command -v apt-get >/dev/null; then
    {
      echo "blossom: packages are missing, and only root on a system with apt has them installed here."
      echo "Install them and run this again:"
      echo "  apt-get install $missing"
      echo "  dnf install $(missing_packages "$1" dnf)"
      echo "  brew install $(missing_packages "$1" brew)"
    } >&2
    exit "$exit_unavailable"
  fi
  echo "blossom: installing $missing" >&2
  log=$(mktemp)
  # shellcheck disable=SC2086 # one word per package
  if ! install_with_apt $missing >"$log" 2>&1 </dev/null; then
    tail -n 20 "$log" >&2
    rm -f "$log"
    echo "blossom: could not install $missing" >&2
    exit "$exit_unavailable"
  fi
  rm -f "$log"
  missing=$(missing_packages "$1" apt)
  if [[ -n $missing ]]; then
    echo "blossom: installed, and still not found: $missing" >&2
    exit "$exit_unavailable"
  fi
}
