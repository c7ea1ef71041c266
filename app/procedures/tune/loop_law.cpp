#include "app/procedures/tune/loop_law.h"

#include "app/procedures/tune/loop_prediction.h"
#include "control/law/board_gains.h"
#include "control/law/filtered_delta.h"

namespace halbench::app {

Result<LoopLaw> checkedLaw(const LoopLaw& law, double period_s) {
    const auto gains =
        law.filtered ? control::checkedGains(*law.filtered, period_s) : control::boardGains(law.law.gains);
    const auto positive = gains ? checkPositionGains(*gains) : failure(gains.error());
    if (!positive) {
        return failure(positive.error());
    }
    control::PositionLaw board = law.law;
    board.gains = *gains;
    board.gains.filter_s.reset();
    if (!law.filtered) {
        return LoopLaw(board);
    }
    control::FilteredLaw filtered = *law.filtered;
    filtered.gains = *gains;
    return LoopLaw(board, std::move(filtered));
}

control::FilteredLaw asFiltered(const LoopLaw& law) {
    if (law.filtered) {
        return *law.filtered;
    }
    control::FilteredLaw board;
    board.gains = law.law.gains;
    return board;
}

control::PositionLaw lawAtRest(const LoopLaw& law, double period_s) {
    control::PositionLaw resting = law.law;
    if (!law.filtered) {
        return resting;
    }
    const auto gains = control::checkedGains(*law.filtered, period_s);
    const auto filters_ratio = control::filterGainAtRest(law.filtered->filters);
    if (gains && filters_ratio) {
        resting.gains = *gains;
        resting.gains.proportional *= *filters_ratio;
        resting.gains.integral *= *filters_ratio;
    }
    resting.gains.filter_s.reset(); // at rest nothing moves
    return resting;
}

} // namespace halbench::app
