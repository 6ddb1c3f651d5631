#include "plots/drawing/gnuplot.hpp"

#include <fmt/core.h>
#include <gnuplot-iostream.h>
#include <stdlib.h>  // mkdtemp is POSIX, not in <cstdlib>

#include <boost/algorithm/string/replace.hpp>
#include <cstdlib>
#include <fstream>

#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/files.hpp"
#include "plots/drawing/words.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The size of a picture, and how large its words, lines and marks are in a format: as on a page, or as many
/// times that.
std::string terminal(const std::string& name, const std::string& size, const Paper& paper, double words,
                     double lines) {
  return fmt::format(
      "set terminal {} {} background '#ffffff' font {} fontscale {:.6g} linewidth {:.6g} enhanced rounded\n",
      name, size, in_quotes(paper.font + ",14"), words, lines);
}

/// The formats draw marks of one size differently; `mark` evens that out.
std::string script(const Drawing& drawing) {
  constexpr double usual = 125, dots = 300;  // pixels of pages that take an inch on paper, and dots in print
  const Paper& paper = drawing.paper;
  const double finer = paper.alone ? dots / paper.per_inch : 1, smaller = usual / paper.per_inch;
  const std::string commands = legible(drawing.commands, paper.least);
  std::string text = "set encoding utf8\n" + drawing.data;
  const auto add = [&](const std::string& terminal, double mark, const char* format) {
    text += terminal + (paper.alone ? "set minussign\n" : "") +
            fmt::format("mark = {:.6g}\nset output 'picture.{}'\n{}\nunset output\nreset\n", mark, format,
                        commands);
  };
  const auto size = [&](double scale, const char* unit) {
    return fmt::format("size {0:.{2}f}{3},{1:.{2}f}{3}", drawing.width * scale, drawing.height * scale,
                       *unit == '\0' ? 0 : 2, unit);
  };
  add(terminal("pngcairo", size(finer, ""), paper, finer, finer), finer, "png");
  add(terminal("svg", size(1, "") + " dynamic", paper, 1.25, 1), 0.55, "svg");
  add(terminal("pdfcairo", size(1 / paper.per_inch, "in"), paper, 0.57 * smaller, smaller), 0.62 * smaller,
      "pdf");
  return text;
}

/// A picture that says how large it is on paper.
std::string with_size(const std::string& svg, const Drawing& drawing) {
  const double millimetres = 25.4 / drawing.paper.per_inch;
  std::string sized = svg;
  const std::size_t tag = std::min(svg.find("<svg"), svg.size());
  return sized.insert(std::min(tag + 4, svg.size()),
                      fmt::format(" width=\"{:.2f}mm\" height=\"{:.2f}mm\"", drawing.width * millimetres,
                                  drawing.height * millimetres));
}

/// The curves of all panels, a point a line; colours without the mark that begins comments elsewhere.
std::string curves_csv(const std::vector<DrawnPanel>& panels) {
  std::string text = "panel,scale,curve,colour,across,x,y\n";
  for (const DrawnPanel& panel : panels)
    for (const DrawnCurve& one : panel.curves) {
      CsvWriter names;
      names.add(panel.up, panel.logarithmic ? "logarithmic" : "linear", one.words, one.colour.substr(1),
                panel.across);
      for (std::size_t i = 0; i < one.curve.size(); ++i)
        text += fmt::format("{},{:.8g},{:.6g}\n", names.text(), one.curve.times[i], one.curve.values[i]);
    }
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

std::string in_quotes(const std::string& text) {
  std::string result = "'";
  for (const char c : text)
    result += c == '\'' ? R"('."'".')" : std::string(1, static_cast<unsigned char>(c) < ' ' ? ' ' : c);
  return result + "'";
}

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
  std::string& svg = pictures.back().second;
  boost::replace_all(svg, R"*(fill="rgb(1,2,3)")*", R"(fill="none")");
  if (drawing.paper.alone) svg = with_size(svg, drawing);
  if (!drawing.panels.empty()) pictures.emplace_back(".csv", curves_csv(drawing.panels));
  fs::create_directories(stem.parent_path());
  for (const auto& [format, picture] : pictures) write_file(fs::path(stem).concat(format), picture);
}

}  // namespace rockstack::plots
