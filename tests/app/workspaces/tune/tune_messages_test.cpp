#include "app/workspaces/tune/tune_messages.h"
#include "tests/widgets/gui_fixture.h"

namespace halbench::app {
namespace {

class TuneMessagesTest : public widgets::GuiTest {
protected:
    QString shown() const { return bar.message().text; }
    static widgets::Message message(const char* text) {
        return {widgets::Severity::Information, text, {}, {}};
    }

    widgets::MessageBar bar;
    TuneMessages messages{bar};
};

TEST_F(TuneMessagesTest, messageOfADeviceEndsWithIt) {
    messages.showOfDevice(message("Applied."));
    messages.clearOfDevice();
    EXPECT_EQ(shown(), "");
    messages.showOfDevice(message("Applied."));
    messages.show(message("Saved."));
    messages.clearOfDevice();
    EXPECT_EQ(shown(), "Saved.") << "of a file, not of a device";
}

TEST_F(TuneMessagesTest, messageOfADepartedDeviceStays) {
    messages.showOfDevice(message("Applied."));
    messages.keepOfDevice();
    messages.clearOfDevice();
    EXPECT_EQ(shown(), "Applied.");
}

TEST_F(TuneMessagesTest, errorAloneIsCleared) {
    messages.show(message("Saved."));
    messages.clearError();
    EXPECT_EQ(shown(), "Saved.");
    messages.showError({ErrorCode::InvalidInput, "no gains", "choose a file"});
    EXPECT_EQ(bar.message().severity, widgets::Severity::Error);
    EXPECT_EQ(bar.message().remedy, "choose a file");
    messages.clearError();
    EXPECT_EQ(shown(), "");
}

} // namespace
} // namespace halbench::app
