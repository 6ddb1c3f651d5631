#include "analytic/scene/ground/records/formats.hpp"

#include <algorithm>
#include <array>

#include "analytic/scene/ground/records/columns.hpp"
#include "analytic/scene/ground/records/cosmos.hpp"
#include "analytic/scene/ground/records/esm.hpp"
#include "analytic/scene/ground/records/knet.hpp"
#include "analytic/scene/ground/records/peer.hpp"
#include "analytic/scene/ground/records/smc.hpp"
#include "analytic/scene/ground/records/volume2.hpp"

namespace rockstack::records {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr char dos_end_of_file = '\x1A';

/// Refuses what is not text, at its first control character.
void check_text(std::string_view file, std::string_view text) {
  const auto is_binary = [](char c) {
    return (c >= 0 && c < ' ' && std::string_view("\t\n\v\f\r").find(c) == std::string_view::npos) ||
           c == '\x7F';
  };
  const auto bad = std::find_if(text.begin(), text.end(), is_binary);
  if (bad == text.end()) return;
  const auto line = static_cast<std::size_t>(std::count(text.begin(), bad, '\n')) + 1;
  Cursor(file, text).fail_at(line, "byte " + std::to_string(static_cast<int>(*bad)) + ": not a text file");
}

}  // namespace

std::vector<Record> read_series(std::string_view file, std::string_view text) {
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  if (text.ends_with(dos_end_of_file)) text.remove_suffix(1);
  const Cursor cursor(file, text);
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) cursor.fail("the file is empty");
  check_text(file, text);
  const std::array formats{&knet, &esm, &cosmos, &smc, &volume2, &peer, &columns};
  for (const Format* format : formats) {
    if (!format->recognises(cursor)) continue;
    std::vector<Record> series = format->read(cursor);
    if (series.empty()) cursor.fail("holds no series of acceleration");
    return series;
  }
  cursor.fail(
      "not a known format: PEER AT2, COSMOS, CSMIP volume 2, USGS SMC, ESM, K-NET/KiK-net, columns of "
      "numbers");
}

}  // namespace rockstack::records
