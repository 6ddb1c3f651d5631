#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "plots/drawing/gnuplot.hpp"
#include "plots/pages/show.hpp"

namespace rockstack::plots {

void print_pdf(const fs::path& page, const fs::path& pdf) {
  if (!has_program("chromium"))
    throw InputError("--pdf: must be asked where the program chromium is; slides.html is written");
  const Scratch scratch(pdf.parent_path().empty() ? fs::path(".") : pdf.parent_path(), ".printing");
  const fs::path made = fs::absolute(scratch.folder / "slides.pdf");
  std::vector<std::string> words{
      "chromium",
      "--headless",
      "--disable-gpu",
      "--no-first-run",
      "--disable-quic",
      "--disable-background-networking",
      "--disable-component-update",
      "--disable-sync",
      "--no-pdf-header-footer",
      "--window-size=1280,768",
      "--virtual-time-budget=20000",
      fmt::format("--user-data-dir={}", fs::absolute(scratch.folder / "profile").string()),
      fmt::format("--print-to-pdf={}", made.string())};
  if (geteuid() == 0) words.emplace_back("--no-sandbox");  // which it does not have for root
  words.push_back(fs::absolute(page).string());
  const std::string line = text_of_each(words, quoted_for_shell, " ") + " >/dev/null 2>&1";
  const int status = std::system(line.c_str());
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (code != 0 || !fs::exists(made))
    throw std::runtime_error(fmt::format("chromium: printing {} ended with {}", page.string(), code));
  fs::rename(made, pdf);
}

}  // namespace rockstack::plots
