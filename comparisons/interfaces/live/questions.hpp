#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>

#include "analytic/scene/ground/motion_library.hpp"
#include "comparisons/interfaces/live/desk.hpp"

namespace rockstack::live {

/// Answers what pages ask, each run in a process of its own that ends when nobody wants it any more.
class Questions {
 public:
  /// `solver`: the program of exact_worker.cpp; `records`: that scenes may name.
  Questions(std::filesystem::path solver, std::set<std::string> records);

  /// {"page", "sequence", "kind": "exact", "engine" or "cloud", "member", "state"}: what answers.hpp says,
  /// with "milliseconds", or "failure" with the reason, or "dropped" for what is no longer wanted. `gone` is
  /// asked now and then: whether the page has left. Safe to call from several threads.
  /// @throws InputError, std::invalid_argument or nlohmann::json::exception for a question that is none.
  std::string answer(const std::string& question, const std::function<bool()>& gone);

  /// {"state", "name", "runs"}: the texts "scene" and "suite" of files to save. @throws likewise.
  std::string files(const std::string& question);

 private:
  std::filesystem::path solver_;
  std::set<std::string> records_;
  MotionLibrary library_{std::size_t{16} << 20U};
  Desk desk_;
};

}  // namespace rockstack::live
