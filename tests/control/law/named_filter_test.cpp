#include "control/base/random.h"
#include "control/law/filtered_delta.h"
#include "control/law/named_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

constexpr double Period_s = 0.01;

/// As the board holds it: in single precision.
LawSection<double> onBoard(const LawSection<double>& section) {
    const auto single = [](double value) { return static_cast<double>(static_cast<float>(value)); };
    return {single(section.b0), single(section.b1), single(section.b2), single(section.a1),
            single(section.a2)};
}

LoopFilter throughTheBoard(const LoopFilter& filter) {
    const auto sections = filterSections({filter}, Period_s);
    EXPECT_TRUE(sections);
    return namedFilter(onBoard(sections->front()), Period_s);
}

// Figures as people write them come back to the digit.
TEST(NamedFilter, knowsEachKindAgain) {
    const std::vector<LoopFilter> filters = {
        LeadFilter{60.0, 35.0},       LagFilter{4.0, 8.0},       NotchFilter{188.5, 0.1, 0.5},
        NotchFilter{120.0, 0.0, 0.2}, LowPassFilter{250.0, 1},   LowPassFilter{250.0, 2},
        LowPassFilter{0.12566, 2},    LowPassFilter{0.12566, 1}, NotchFilter{12.0, 0.3, 2.0},
    };
    for (const LoopFilter& filter : filters) {
        EXPECT_EQ(throughTheBoard(filter), filter) << filter.index() << " " << frequencyOf_rad_s(filter);
    }
}

// Random figures of six digits: a filter of the same kind, whose response is the same to single precision.
TEST(NamedFilter, hasTheResponseOfRandomFilters) {
    Random random(7);
    const auto between = [&random](double low, double high) {
        return low * std::pow(high / low, random.uniform());
    };
    for (int run = 0; run < 300; ++run) {
        const double frequency_rad_s = between(1.0, 280.0);
        const LoopFilter filter =
            run % 4 == 0   ? LoopFilter(LeadFilter{frequency_rad_s, between(5.0, 60.0)})
            : run % 4 == 1 ? LoopFilter(LagFilter{frequency_rad_s, between(1.5, 20.0)})
            : run % 4 == 2 ? LoopFilter(NotchFilter{frequency_rad_s, between(0.01, 0.9), between(0.05, 2.0)})
                           : LoopFilter(LowPassFilter{frequency_rad_s, 1 + run / 4 % 2});
        const LoopFilter named = throughTheBoard(filter);
        const auto asked = sampledFilter(filter, Period_s);
        const auto found = sampledFilter(named, Period_s);
        ASSERT_TRUE(asked && found) << run;
        for (const double w : {0.1, 3.0, 40.0, 200.0}) {
            // Coefficients to 1e-7; at 0.1 rad/s in powers of z, as here, cancellation leaves 1e-3 of them.
            EXPECT_LT(std::abs(found->atFrequency(w) / asked->atFrequency(w) - 1.0), 1e-3) << run << " " << w;
        }
        EXPECT_EQ(named.index(), filter.index()) << run;
    }
}

TEST(NamedFilter, leavesAnotherSectionAsItIs) {
    const LawSection<double> other{0.7, 0.2, 0.05, 0.6, 0.1};
    EXPECT_EQ(namedFilter(other, Period_s), LoopFilter(SectionFilter{other}));
    EXPECT_TRUE(sampledFilter(SectionFilter{other}, Period_s));
}

// A section as it is has the response of the filter that it was made of, and the same section again.
TEST(NamedFilter, aSectionRunsAsTheFilterItWasMadeOf) {
    const LoopFilter notch = NotchFilter{180.0, 0.1, 0.5};
    const auto sections = filterSections({notch}, Period_s);
    const LoopFilter given = SectionFilter{sections->front()};
    for (const double w : {1.0, 50.0, 180.0, 300.0}) {
        EXPECT_LT(std::abs(sampledFilter(given, Period_s)->atFrequency(w) -
                           sampledFilter(notch, Period_s)->atFrequency(w)),
                  1e-9)
            << w;
    }
    EXPECT_EQ(filterSections({given}, Period_s)->front(), sections->front());
    EXPECT_NEAR(*filterGainAtRest({given}), 1.0, 1e-12);
}

TEST(NamedFilter, aSectionThatIsNotStableIsRefused) {
    for (const LawSection<double>& wrong :
         {LawSection<double>{1.0, 0.0, 0.1, 0.1, 0.2},    // a2 > a1
          LawSection<double>{1.0, 0.0, 0.1, 0.5, -0.1},   // a2 < 0
          LawSection<double>{1.0, 0.1, 0.0, 2.5, 0.0},    // one root left of -2
          LawSection<double>{1.0, 0.0, 0.1, 3.9, 3.5}}) { // beyond Nyquist
        EXPECT_EQ(sampledFilter(SectionFilter{wrong}, Period_s).error().code, ErrorCode::OutOfRange);
    }
    EXPECT_TRUE(sampledFilter(SectionFilter{LawSection<double>{}}, Period_s)) << "off";
}

} // namespace
} // namespace halbench::control
