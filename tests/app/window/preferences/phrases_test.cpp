#include "app/documents/presets.h"
#include "app/window/preferences/language.h"
#include "app/workbench/fault_text.h"
#include "control/base/units.h"
#include "control/design/design_methods.h"
#include "devices/open/open_device.h"
#include "devices/simulated/registry/simulated_models.h"
#include "tests/app/window/window_test.h"
#include "widgets/language/phrasebook.h"

#include <QRegularExpression>

namespace halbench::app {
namespace {

/// Walks what the program really has, not a list of it, in each language.
class PhrasesTest : public WindowTest, public testing::WithParamInterface<const char*> {
protected:
    PhrasesTest() { speak(application, GetParam()); }
    ~PhrasesTest() override { QLocale::setDefault(QLocale::c()); }

    /// Formulas, units and names are the same in every language: no word of four letters in them.
    static bool hasWords(const QString& text) {
        static const QRegularExpression word(QStringLiteral("[A-Za-z]{4}"));
        return word.match(text).hasMatch();
    }

    static void expectKnown(const std::string& english, const std::string& place) {
        const QString text = QString::fromStdString(english);
        EXPECT_TRUE(!hasWords(text) || widgets::isInPhrasebook(text)) << place << ": " << english;
    }

    static void expectKnown(const std::vector<std::string>& choices, const std::string& place) {
        for (const std::string& choice : choices) {
            expectKnown(choice, place);
        }
    }
};

TEST_P(PhrasesTest, haveEveryWordOfTheSimulatedBoardsCatalogues) {
    for (const devices::SimulatedModel& model : devices::simulatedModels()) {
        if (model.name == "toy" || model.name == "sense") {
            continue; // other tests of this program register them, without translations
        }
        const auto device = devices::openDevice("sim:" + model.name, {});
        ASSERT_TRUE(device) << model.name;
        expectKnown(model.title, model.name);
        const devices::Catalogue& catalogue = (*device)->catalogue();
        ASSERT_FALSE(catalogue.signals.empty());
        for (const SignalSpec& spec : catalogue.signals) {
            expectKnown(spec.help, spec.name);
            expectKnown(spec.choices, spec.name);
        }
        for (const ParameterSpec& spec : catalogue.parameters) {
            expectKnown(spec.help, spec.name);
            expectKnown(spec.group, spec.name);
            expectKnown(spec.choices, spec.name);
        }
    }
}

TEST_P(PhrasesTest, haveEveryOptionOfASimulation) {
    for (const devices::SimulatedModel& model : devices::simulatedModels()) {
        for (const devices::OverrideSpec& spec : model.keys) {
            expectKnown(spec.meaning, spec.key);
        }
    }
}

TEST_P(PhrasesTest, haveEveryFaultOfTheBoard) {
    open();
    connectMotor(1.0);
    const SignalSpec* fault = session().catalogue().findSignal("fault");
    ASSERT_NE(fault, nullptr);
    ASSERT_GE(fault->choices.size(), 8U);
    for (std::size_t code = 1; code < fault->choices.size(); ++code) {
        devices::DeviceState board;
        board.fault = static_cast<std::uint32_t>(code);
        board.faultText = fault->choices[code];
        const QString english = QString::fromStdString(board.faultText);
        EXPECT_NE(widgets::inWords(english), english);
        EXPECT_FALSE(faultWords(board).what.contains(english));
    }
}

TEST_P(PhrasesTest, haveEveryPresetMethodAndMeasure) {
    for (const std::string& preset : presetNames()) {
        expectKnown(findPreset("htm", preset)->title, preset);
    }
    for (const control::DesignMethod& method : control::designMethods()) {
        expectKnown(std::string(method.summary), std::string(method.name));
    }
    for (const Unit& unit : units()) {
        expectKnown(std::string(unit.quantity), std::string(unit.symbol));
    }
}

TEST_P(PhrasesTest, haveWhatTheListOfDevicesSays) {
    for (const devices::DeviceListing& listing : devices::listDevices()) {
        expectKnown(listing.reason, listing.uri);
        expectKnown(listing.hint, listing.uri);
    }
}

INSTANTIATE_TEST_SUITE_P(Window, PhrasesTest, testing::Values("de", "zh_CN"),
                         [](const testing::TestParamInfo<const char*>& language) {
                             return std::string(language.param);
                         });

} // namespace
} // namespace halbench::app
