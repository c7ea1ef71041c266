#include "app/procedures/loop_law.h"

#include "app/procedures/loop_prediction.h"
#include "control/design/board_gains.h"

namespace halbench::app {

Result<LoopLaw> checkedLaw(const LoopLaw& law, double period_s) {
    const auto gains =
        law.shaped ? control::checkedGains(*law.shaped, period_s) : control::boardGains(law.law.gains);
    const auto positive = gains ? checkPositionGains(*gains) : failure(gains.error());
    if (!positive) {
        return failure(positive.error());
    }
    control::PositionLaw board = law.law;
    board.gains = *gains;
    board.gains.filter_s.reset();
    if (!law.shaped) {
        return LoopLaw(board);
    }
    control::ShapedLaw shaped = *law.shaped;
    shaped.gains = *gains;
    return LoopLaw(board, std::move(shaped));
}

control::PositionLaw lawAtRest(const LoopLaw& law, double period_s) {
    control::PositionLaw resting = law.law;
    if (!law.shaped) {
        return resting;
    }
    const auto gains = control::checkedGains(*law.shaped, period_s);
    const auto filters = control::filtersInSeries(law.shaped->filters, period_s);
    if (gains && filters) {
        resting.gains = *gains;
        resting.gains.proportional *= filters->dcGain();
        resting.gains.integral *= filters->dcGain();
    }
    resting.gains.filter_s.reset(); // at rest nothing moves
    return resting;
}

} // namespace halbench::app
