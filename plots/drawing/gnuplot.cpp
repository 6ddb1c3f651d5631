#include "plots/drawing/gnuplot.hpp"

#include <fmt/core.h>
#include <gnuplot-iostream.h>
#include <stdlib.h>  // mkdtemp is POSIX, not in <cstdlib>

#include <boost/algorithm/string/replace.hpp>
#include <cstdlib>
#include <fstream>

#include "comparisons/measures/results/files.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The formats draw marks of one size differently; `mark` evens that out.
std::string script(const Drawing& drawing) {
  constexpr double per_inch = 125;  // pixels of the others that take an inch on paper
  const std::string size = fmt::format("size {},{}", drawing.width, drawing.height);
  std::string text = "set encoding utf8\n" + drawing.data;
  const auto add = [&](const std::string& terminal, const std::string& scale, double mark,
                       const char* format) {
    text += fmt::format(
        "set terminal {} background '#ffffff' font 'DejaVu Sans,14' {} enhanced rounded\nmark = {}\n"
        "set output 'picture.{}'\n{}\nunset output\nreset\n",
        terminal, scale, mark, format, drawing.commands);
  };
  add("pngcairo " + size, "", 1, "png");
  add("svg " + size + " dynamic", "fontscale 1.25", 0.55, "svg");
  add(fmt::format("pdfcairo size {:.2f}in,{:.2f}in", drawing.width / per_inch, drawing.height / per_inch),
      "fontscale 0.57", 0.62, "pdf");
  return text;
}

std::string complaint(const fs::path& folder) {
  std::string text = contents(folder / "errors");
  for (char& c : text)
    if (c == '\n' || c == '\t') c = ' ';
  return text.substr(text.size() - std::min<std::size_t>(text.size(), 400));
}

/// Has gnuplot draw into a folder. @throws std::runtime_error where it did not run, or failed.
void run_gnuplot(const fs::path& folder, const std::string& script, const fs::path& stem, double time_limit) {
  // The shell outlives gnuplot and takes what gnuplot left unread: a pipe that breaks would end this process.
  // Where this process has been killed meanwhile, it clears up. What the user's environment says about
  // gnuplot's terminal does not count.
  const std::string command = fmt::format(
      "cd {0}; unset GNUTERM; LC_ALL=C.UTF-8 /usr/bin/timeout -k 1 {1} gnuplot -d - 2>{0}/errors >&2; "
      "echo $? >{0}/status; while read -r _; do :; done; kill -0 $PPID 2>{0}/gone || rm -rf {0}",
      quoted_for_shell(folder.string()), time_limit);
  {
    Gnuplot pipe(command);
    pipe << script;
  }
  const std::string status = contents(folder / "status");
  if (status == "124\n")
    throw std::runtime_error(fmt::format("gnuplot has not drawn {} within {} s", stem.string(), time_limit));
  if (status == "127\n")
    throw std::runtime_error(
        fmt::format("cannot draw {}: gnuplot is not installed, or not in PATH", stem.string()));
  if (status != "0\n")
    throw std::runtime_error(fmt::format("gnuplot failed to draw {} (status {}): {}", stem.string(),
                                         status.substr(0, status.find('\n')), complaint(folder)));
}

}  // namespace

Scratch::Scratch(const fs::path& within, const std::string& name) {
  std::string made = (within / (name + "-XXXXXX")).string();
  if (mkdtemp(made.data()) == nullptr) throw std::runtime_error(made + ": no such folder can be made");
  folder = made;
}

Scratch::~Scratch() {
  std::error_code ignored;
  fs::remove_all(folder, ignored);
}

std::string quoted_for_shell(const std::string& text) {
  return "'" + boost::replace_all_copy(text, "'", "'\\''") + "'";
}

bool has_program(const std::string& name) {
  return std::system(fmt::format("command -v {} >/dev/null 2>&1", name).c_str()) == 0;
}

void draw(const Drawing& drawing, const fs::path& stem) {
  const Scratch scratch(fs::temp_directory_path(), "rockstack");
  run_gnuplot(scratch.folder, script(drawing), stem, drawing.time_limit);
  std::vector<std::pair<const char*, std::string>> pictures;
  for (const auto& [format, end] : {std::pair{".png", "IEND"}, {".pdf", "%%EOF"}, {".svg", "</svg>"}}) {
    const std::string& picture =
        pictures.emplace_back(format, contents(scratch.folder / fs::path("picture").concat(format))).second;
    if (picture.find(end) == std::string::npos)
      throw std::runtime_error(
          fmt::format("gnuplot left {} unfinished: {}", stem.string(), complaint(scratch.folder)));
  }
  // Words in the unseen colour have no fill: gnuplot's SVG knows no transparent ones.
  boost::replace_all(pictures.back().second, R"*(fill="rgb(1,2,3)")*", R"(fill="none")");
  fs::create_directories(stem.parent_path());
  for (const auto& [format, picture] : pictures) write_file(fs::path(stem).concat(format), picture);
}

}  // namespace rockstack::plots
