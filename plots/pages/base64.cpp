#include "plots/pages/base64.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace rockstack::plots {
namespace {

constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::vector<unsigned char> bytes_of(const std::vector<float>& numbers) {
  std::vector<unsigned char> bytes;
  bytes.reserve(4 * numbers.size());
  for (const float number : numbers) {
    const auto bits = std::bit_cast<std::uint32_t>(number);
    for (int shift = 0; shift < 32; shift += 8)
      bytes.push_back(static_cast<unsigned char>((bits >> shift) & 0xFFU));
  }
  return bytes;
}

}  // namespace

std::string base64(const std::vector<float>& numbers) {
  const std::vector<unsigned char> bytes = bytes_of(numbers);
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j) group = group << 8U | (j < count ? bytes[i + j] : 0U);
    for (std::size_t j = 0; j < 4; ++j)
      text += j <= count ? digits[(group >> (18U - 6U * static_cast<unsigned>(j))) & 63U] : '=';
  }
  return text;
}

}  // namespace rockstack::plots
