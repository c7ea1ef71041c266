#include "app/window/docks/dock_layout.h"
#include "app/window/preferences/language.h"
#include "tests/app/window/window_test.h"
#include "widgets/parameters/parameter_table_model.h"

#include <QHeaderView>
#include <QTreeView>

namespace halbench::gui {
namespace {

using app::Perspective;

/// The screens of ordinary notebooks, in every language.
class PanelRoomTest : public app::WindowTest, public testing::WithParamInterface<const char*> {
protected:
    ~PanelRoomTest() override { QLocale::setDefault(QLocale::c()); }

    QTreeView* parameters() {
        for (auto* view : window->docks().panel("parameters")->findChildren<QTreeView*>()) {
            if (view->isVisible() && view->model()->columnCount() == widgets::ParameterTableModel::Columns) {
                return view;
            }
        }
        return nullptr;
    }
};

TEST_P(PanelRoomTest, everyUnitOfTheParametersIsReadWithoutScrolling) {
    app::speak(application, GetParam());
    open();
    connectMotor(1.0);
    constexpr int Unit = widgets::ParameterTableModel::UnitColumn;
    for (const QSize size : {QSize(1440, 900), QSize(1366, 768)}) {
        window->resize(size);
        for (const Perspective perspective : {Perspective::Monitor, Perspective::Tune}) {
            window->docks().setPerspective(perspective);
            window->docks().raise("parameters");
            ASSERT_TRUE(wait([&] { return parameters() != nullptr; }));
            QTest::qWait(50); // one frame of the window
            const QTreeView& view = *parameters();
            const int right_px = view.header()->sectionViewportPosition(Unit) + view.columnWidth(Unit);
            EXPECT_LE(right_px, view.viewport()->width()) << size.width();
            for (int group = 0; group < view.model()->rowCount(); ++group) {
                const QModelIndex heading = view.model()->index(group, 0);
                for (int row = 0; row < view.model()->rowCount(heading); ++row) {
                    const QModelIndex unit = view.model()->index(row, Unit, heading);
                    EXPECT_LE(view.sizeHintForIndex(unit).width(), view.columnWidth(Unit))
                        << unit.data().toString().toStdString();
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Gui, PanelRoomTest, testing::Values("en", "de", "zh_CN"),
                         [](const testing::TestParamInfo<const char*>& language) {
                             return std::string(language.param);
                         });

} // namespace
} // namespace halbench::gui
