#pragma once

#include "app/documents/model_file.h"
#include "app/workbench/shared_results.h"
#include "app/workspaces/parts/preflight.h"
#include "app/workspaces/tune/loop/tune_form.h"
#include "app/workspaces/tune/tune_numbers.h"
#include "app/workspaces/tune/tune_panel.h"
#include "tests/app/workspaces/panel_fixture.h"
#include "tests/app/workspaces/published_motor.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/optional_number_edit.h"
#include "widgets/controls/verdict_view.h"
#include "widgets/figure/figure_view.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace halbench::app {

class TunePanelTest : public PanelTest {
protected:
    void SetUp() override {
        PanelTest::SetUp();
        bench.setDisplayUnits(
            {widgets::AngleUnit::Radian, SpeedUnit::RadiansPerSecond}); // as the board counts
        panel.setFileChooser({[this](QWidget*, const FileQuestion&) { return gainsPath(); }, {}});
        show(panel);
    }

    QString gainsPath() const { return m_folder.filePath("gains.json"); }
    widgets::OptionalNumberEdit* edit(const char* name) const {
        return panel.findChild<widgets::OptionalNumberEdit*>(name);
    }
    double shown(const char* name) const { return edit(name)->value().value_or(-1.0); }
    QString message() const { return panel.findChild<widgets::MessageBar*>()->message().text; }
    QString verdict() const { return panel.findChild<widgets::VerdictView*>("design")->text(); }
    QString agreement() const { return panel.findChild<widgets::VerdictView*>("agreement")->text(); }
    bool canApply() const { return isEnabled(panel, "Apply and verify"); }

    void type(const char* name, const char* text) {
        edit(name)->setFocus();
        QTest::keyClick(edit(name), Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(edit(name), text);
    }

    void choose(const QString& accessibleName, const QString& text) {
        for (auto* box : panel.findChildren<QComboBox*>()) {
            if (box->accessibleName() == accessibleName) {
                ASSERT_GE(box->findText(text), 0) << text.toStdString();
                box->setFocus();
                QTest::keyClick(box, Qt::Key_Home);
                for (int i = 0; i < box->findText(text); ++i) {
                    QTest::keyClick(box, Qt::Key_Down);
                }
                ASSERT_EQ(box->currentText(), text);
                return;
            }
        }
        FAIL() << accessibleName.toStdString();
    }

    const widgets::FigureView* figure(const QString& title) const {
        for (auto* view : panel.findChildren<widgets::FigureView*>()) {
            if (view->accessibleName().startsWith(title)) {
                return view;
            }
        }
        return nullptr;
    }
    /// The curve of this name in the upper panel of a picture.
    std::vector<double> curve(const QString& title, const std::string& label) const {
        const widgets::FigureView* view = figure(title);
        for (const widgets::Curve& each : view->figure().panels.at(0).curves) {
            if (each.label == label) {
                return each.y;
            }
        }
        return {};
    }
    /// All that the checks before the start say.
    QString checks() const {
        QStringList lines;
        for (const auto* line : panel.findChild<Preflight*>()->findChildren<QLabel*>()) {
            lines << line->text();
        }
        return lines.join('\n');
    }
    bool hasVerification() const {
        return figure("Verification") != nullptr || agreement().contains("predicted band") ||
               button(panel, "Verification")->isEnabled();
    }
    void verify() {
        click(panel, "Apply and verify");
        ASSERT_TRUE(wait([&] { return isEnabled(panel, "Keep"); })) << message().toStdString();
    }
    /// Words as they are read, without what keeps a number and its unit in one line.
    static QString plain(QString text) {
        return text.remove(QChar(0x2060)).replace(QChar(0x00a0), QLatin1Char(' '));
    }
    static QString focused() {
        const QWidget* widget = QApplication::focusWidget();
        return widget == nullptr ? QString() : widget->accessibleName();
    }

    /// A motor that is known and a device that could take the recommended gains.
    void prepare(const QString& uri = "sim:htm?seed=4", double speed_ratio = 0.0) {
        connectMotor(uri, speed_ratio);
        bench.setIdentification(publishedMotor());
        ASSERT_TRUE(wait([&] { return canApply(); })) << verdict().toStdString();
    }

    QTemporaryDir m_folder;
    TunePanel panel{bench};
};

} // namespace halbench::app
