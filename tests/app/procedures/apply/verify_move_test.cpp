#include "app/procedures/apply/verify_move.h"
#include "tests/app/procedures/simulated_motor.h"
#include "tests/app/procedures/uncertain_motor.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

// The move is that of the gains that run now, whatever they are; the caller has the guard.
TEST(VerifyMove, judgesTheGainsThatRun) {
    for (const char* query : {"imperfections=off", "imperfections=off&J=2.5e-3"}) {
        const auto device = openMotor(query);
        setLaw(*device, models::recommendedLaw(models::RotorConfig{}, 1.43e-2));
        std::vector<ProcedureState> states;
        ProcedureObserver observer;
        observer.onState = [&](ProcedureState state) { states.push_back(state); };
        ApplyResult result;
        auto guard = RestoreGuard::take(*device);
        ASSERT_TRUE(guard);
        const auto verified = verifyMove(*device, stepVerification(uncertainMotor(0.02)), observer, result);
        ASSERT_TRUE(verified) << verified.error().message;
        EXPECT_EQ(states, std::vector<ProcedureState>{ProcedureState::Verify});
        ASSERT_TRUE(result.predicted && result.verification && result.band);
        const bool isThisMotor = std::string(query) == "imperfections=off";
        EXPECT_EQ(result.quality.verdict != Verdict::Refused, isThisMotor) << query;
        EXPECT_FALSE(result.isKept) << "that is for the caller to say";
    }
}

TEST(VerifyMove, isTheMoveThatIsAnnounced) {
    const ApplyVerification verification = stepVerification(uncertainMotor(0.02));
    EXPECT_EQ(moveOf(verification).duration_s, verification.duration_s);
    EXPECT_EQ(moveOf(verification).reference.amplitude, 0.5);
}

} // namespace
} // namespace halbench::app
