#include "analytic/scene/ground/records/format.hpp"

#include <utility>

namespace rockstack::records {

Record make_record(double interval, std::vector<double> samples, double factor, std::string format) {
  for (double& sample : samples) sample *= factor;
  return {interval, std::move(samples), std::move(format)};
}

}  // namespace rockstack::records
