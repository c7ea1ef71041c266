#pragma once

#include "app/documents/result_header.h"
#include "app/documents/text/json_value.h"
#include "app/workbench/file_chooser.h"
#include "app/workbench/file_queue.h"
#include "app/workbench/workbench.h"

#include <QPointer>
#include <QWidget>

#include <functional>
#include <utility>
#include <vector>

class QLabel;
class QVBoxLayout;
class QPushButton;
class QStackedWidget;

namespace halbench::widgets {
class MessageBar;
class StepList;
enum class StepState;
} // namespace halbench::widgets

namespace halbench::app {

/// Base of the panels of procedures: steps at the left, a message in place, pages; starts the session's
/// procedure, says how it ended, saves its document. Thread: GUI.
class WizardPanel : public QWidget {
    Q_OBJECT
public:
    /// Without a chooser there is nothing to save to or load from, and no button for it.
    void setFileChooser(FileChooser chooser);

protected:
    WizardPanel(Workbench& bench, QWidget* parent);

    Workbench& bench() const { return m_bench; }
    const FileChooser& chooser() const { return m_chooser; }
    widgets::MessageBar& messages() { return *m_message; }
    FileQueue& files() { return m_files; }

    /// Names of the steps; what they are at stays when the language changes.
    void setSteps(const QStringList& names);
    /// Everything before is done, this one runs, everything after waits.
    void runStep(int step);
    void endStep(int step, widgets::StepState state);
    void resetSteps(); ///< all wait

    /// The layout of a page, without margins: the panel has them.
    static QVBoxLayout* columnOf(QWidget* page, int spacing_px);
    /// `footer` stands below the page and never scrolls out of sight.
    void addPage(QWidget* page, bool isScrolled, QWidget* footer = nullptr);
    void showPage(int page);
    /// Footer of a page of settings: what begins the motion is in sight whatever is said above, with the
    /// speed of simulated time beside it. Ctrl+Return clicks it.
    QWidget* makeStartRow(QPushButton& start, QPushButton* beside = nullptr);

    /// A page of settings: what it is for, the choices, what will happen, what must be so before.
    static QWidget* makePreparation(QLabel& intro, QWidget& form, QLabel& outlook, QWidget& preflight);
    /// What stands in the place of all of this for a device of another kind.
    void setAlternative(QWidget& other);
    void showAlternative(bool isShown);

    /// Footer of a page of results.
    static QWidget* makeButtonRow(const std::vector<QPushButton*>& buttons);
    /// Back to a page of settings, all steps before one.
    void beginAgain(int page, QPushButton& start);

    /// Runs `function(Device&, const ProcedureObserver&) -> Result<T>`, which commands currents; `then(const
    /// Result<T>&)` follows while this panel lives. False, with a message, when it cannot start.
    template <typename Function, typename Then>
    bool runProcedure(const QString& name, Function function, Then then);
    /// Whether the running procedure is this panel's.
    bool isMine() const { return m_isMine; }

    /// The step that runs has failed; back to the first page.
    void fail(const Error& error, const QString& cancelledText);
    /// The message says that the procedure ended because its device went (departure_text.h).
    bool isDepartureTold() const;
    void showError(const Error& error);

    /// Header of a result of the device that is connected; it begins now.
    ResultHeader headerOf(const char* schema, std::uint64_t seed) const;
    /// Asks for a file and writes the document to it.
    void save(const FileQuestion& question, std::function<JsonValue()> document);

    virtual void refreshWords() = 0;
    virtual void onFileChooser() = 0; ///< shows and hides the buttons
    void changeEvent(QEvent* event) override;

private:
    bool couldStart(bool hasStarted);

    Workbench& m_bench;
    FileChooser m_chooser;
    FileQueue m_files;
    bool m_isMine = false;
    QWidget* m_own = nullptr; ///< steps, message and pages
    QWidget* m_alternative = nullptr;
    QString m_departure; ///< the message while it is of that
    widgets::StepList* m_steps = nullptr;
    widgets::MessageBar* m_message = nullptr;
    QStackedWidget* m_pages = nullptr;
};

template <typename Function, typename Then>
bool WizardPanel::runProcedure(const QString& name, Function function, Then then) {
    const QPointer<WizardPanel> self(this);
    return couldStart(m_bench.session().runProcedure(name, std::move(function),
                                                     [self, then = std::move(then)](const auto& result) {
                                                         if (self) {
                                                             self->m_isMine = false;
                                                             then(result);
                                                         }
                                                     }));
}

/// Text, tooltip and accessible name of a button.
void sayButton(QPushButton& button, const QString& text, const QString& help);

/// The seed as batch mode takes it: that of the simulated device, else 1.
std::uint64_t seedOf(const devices::DeviceInfo& device);

} // namespace halbench::app
