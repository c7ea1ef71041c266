#include "control/robustness/percentiles.h"

#include "control/base/assert.h"

#include <algorithm>
#include <cmath>

namespace halbench::control {

MiddleNineTenths middleNineTenths(Eigen::ArrayXd& values) {
    HB_ASSERT(values.size() > 0);
    const auto rank = [&](double share_ratio) {
        return static_cast<Eigen::Index>(std::ceil(share_ratio * static_cast<double>(values.size()))) - 1;
    };
    double* const begin = values.data();
    double* const end = begin + values.size();
    double* const low = begin + rank(0.05);
    double* const high = begin + rank(0.95);
    std::nth_element(begin, low, end);
    if (high > low) {
        std::nth_element(low + 1, high, end); // the larger ones stand behind already
    }
    return {*low, *high};
}

} // namespace halbench::control
