#include "tests/analytic/scene/ground/records/layouts.hpp"

#include <array>
#include <cstdio>
#include <stdexcept>

#include "analytic/scene/ground/records/record_file.hpp"
#include "analytic/scene/messages/input_error.hpp"

namespace rockstack {
namespace {

std::string printed(const char* format, double value) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, value);
  return buffer.data();
}

std::string repeated(const std::string& line, int times) {
  std::string result;
  for (int k = 0; k < times; ++k) result += line;
  return result;
}

std::size_t start_of_line(const std::string& text, std::size_t number) {
  std::size_t at = 0;
  for (; number > 1; --number) at = text.find('\n', at) + 1;
  return at;
}

}  // namespace

std::vector<double> made_up_samples(std::size_t count) {
  constexpr int thousandths = 1000;
  std::vector<double> samples(count);
  int value = 123;
  for (double& sample : samples) {
    sample = static_cast<double>(value - 900) / thousandths;
    value = (value * 37 + 11) % 1801;
  }
  return samples;
}

std::string in_columns(const std::vector<double>& values, const char* format, std::size_t per_line) {
  std::string text;
  for (std::size_t k = 0; k < values.size(); ++k) {
    text += printed(format, values[k]);
    if ((k + 1) % per_line == 0 || k + 1 == values.size()) text += "\n";
  }
  return text;
}

std::string peer_text(const std::vector<double>& samples, const std::string& npts,
                      const std::string& interval) {
  return "MADE-UP RECORD\nNowhere, 1/1/2000\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS=   " + npts +
         ", DT=   " + interval + " SEC\n" + in_columns(samples, "%15.7E", 5);
}

std::string cosmos_channel(const std::vector<double>& samples, const std::string& quantity,
                           const std::string& units) {
  std::vector<double> integers(20, -999);
  integers[2] = 4;
  std::vector<double> reals(66, -999);
  reals[33] = 0.005;
  reals[61] = 10;
  return "Corrected acceleration    (Format v01.20 with 4 text lines) Src: made up\nNowhere\nNobody\n"
         "Values used when parameter or data value is unknown/unspecified:   -999, -999.0\n"
         " 20 Integer-header values follow on  2 lines, Format= (10I8)\n" +
         in_columns(integers, "%8.0f", 10) +
         " 66 Real-header values follow on  11 lines, Format= (6F13.6)\n" + in_columns(reals, "%13.6f", 6) +
         "  1 Comment line(s) follow, each starting with a \"|\":\n | made up\n  " +
         std::to_string(samples.size()) + "  " + quantity + " pts, approx   0 secs, units=" + units +
         ",Format=(8F10.5)\n" + in_columns(samples, "%10.5f", 8) + "/&  ----------  End of data\n";
}

std::string volume2_channel(const std::vector<double>& samples) {
  const std::string points = "   " + std::to_string(samples.size()) + " points of ";
  std::vector<double> reals(100, 0.0);
  reals[60] = 0.0025;
  return repeated("made up\n", 25) + in_columns(std::vector<double>(100, 0), "%5.0f", 16) +
         in_columns(reals, "%10.6f", 8) + points +
         "accel data equally spaced at  .003 sec, in cm/sec2. (8f10.6)\n" + in_columns(samples, "%10.6f", 8) +
         points + "veloc data equally spaced at  .003 sec, in cm/sec.  (8f10.7)\n" +
         in_columns(samples, "%10.7f", 8) + "/&  ----------  End of data for channel\n";
}

std::string smc_text(const std::vector<double>& samples, const std::string& title) {
  const auto integer = [](double value) { return printed("%10.0f", value); };
  const std::string nulls = repeated(integer(-32768), 8) + "\n";
  const std::string counts = repeated(integer(-32768), 7) + integer(1) + "\n" +
                             integer(static_cast<double>(samples.size())) + repeated(integer(-32768), 7) +
                             "\n";
  std::vector<double> reals(50, 1.7e38);
  reals[1] = 200;
  std::string data;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    std::string cell =
        printed("%11.4E", samples[k]);  // Fortran's one-digit exponent: 1.2000E-01 is 1.2000E-1
    cell.erase(cell.size() - 2, 1);
    data += cell + ((k + 1) % 8 == 0 || k + 1 == samples.size() ? "\n" : "");
  }
  return title + "\n" + repeated("*\n", 10) + nulls + counts + repeated(nulls, 3) +
         in_columns(reals, "%15.7E", 5) + "| made up\n" + data;
}

std::string geonet_component(const std::vector<double>& samples) {
  std::vector<double> integers(40, 0), reals(60, 0);
  integers[33] = integers[34] = static_cast<double>(samples.size());
  reals[24] = 0.005;
  reals[25] = 0.02;
  return repeated("Made up\n", 9) + "Number of points    19    Duration 0.36 s\n" +
         "Raw readings in units of 1.00 mm/s/s  at intervals of 0.020 s\n" + repeated("made up\n", 4) +
         "Displacement record unevaluated\n" + in_columns(integers, "%8.0f", 10) +
         in_columns(reals, "%8.4f", 10) + in_columns(samples, "%8.3f", 10) + in_columns(samples, "%8.2f", 10);
}

std::string esm_text(const std::vector<double>& samples, const std::string& units) {
  return "EVENT_NAME: NOWHERE\nDATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS: 20000101_000000.000\n"
         "SAMPLING_INTERVAL_S: 0.005000\nNDATA: " +
         std::to_string(samples.size()) + "\nUNITS: " + units +
         "\nPGA_CM/S^2: 0\nDATA_TYPE: ACCELERATION\nUSER1: /a:b\n" + in_columns(samples, "%.6f", 1);
}

std::string knet_text(const std::vector<double>& samples) {
  std::vector<double> counts = samples;
  for (double& count : counts) count = 1000 * count + 7;
  return "Origin Time       2000/01/01 00:00:00\nStation Code      NONE\nSampling Freq(Hz) 10Hz\n"
         "Duration Time(s)  2\nDir.              E-W\nScale Factor      2(gal)/2000\nMemo.             \n" +
         in_columns(counts, "%8.0f ", 8);
}

std::string one_column_text(const std::vector<double>& samples) {
  return "# made up\n# units: m/s2\n# dt = 0.02 s\n" + in_columns(samples, "%.3f", 1);
}

std::string two_column_text(const std::vector<double>& samples, double interval) {
  std::string text = "time (s), acceleration (cm/s^2)\n";
  for (std::size_t k = 0; k < samples.size(); ++k) {
    text += printed("%.4f,", static_cast<double>(k) * interval) + printed("%.3f\n", samples[k]);
  }
  return text;
}

std::string with_line(const std::string& text, std::size_t number, const std::string& replacement) {
  const std::size_t start = start_of_line(text, number);
  return std::string(text).replace(start, text.find('\n', start) - start, replacement);
}

std::string without_line(const std::string& text, std::size_t number) {
  const std::size_t start = start_of_line(text, number);
  return std::string(text).erase(start, text.find('\n', start) + 1 - start);
}

std::string with(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("the text has no " + from);
  return std::string(text).replace(at, from.size(), to);
}

std::string with_windows_line_ends(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '\n' ? "\r\n" : std::string(1, c);
  return result;
}

Record read_text(const std::string& text) {
  std::vector<Record> series = records::read_series("file", text);
  if (series.size() != 1) throw std::logic_error("more than one series");
  return series.front();
}

std::string error_of_text(const std::string& text) {
  try {
    records::read_series("file", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace rockstack
