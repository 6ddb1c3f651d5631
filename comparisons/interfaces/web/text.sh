# text.sh OUT WASM [LIBRARY SIMULATION WORKER]: C++ that holds the solver, and an engine with what runs it, compressed and in base 64. The worker's
# module becomes a function, adapter(serve), and needs no imports.
set -eu
exec >"$1"
shift
packed() { gzip -9nc | base64 -w0; }
echo '#include "plots/pages/page_solver.hpp"'
printf 'const std::string_view rockstack::plots::solver_wasm = R"('
packed <"$1"
printf ')";\nconst std::string_view rockstack::plots::engine_package = R"('
if [ $# -gt 1 ]; then
  { cat "$2"; echo; sed 's/^export //' "$3"; echo 'const adapter = async (serve) => {'; sed '1d; /^import /d' "$4"; echo '};'; } | packed
fi
echo ')";'
