#pragma once

#include "app/workbench/document_files.h"
#include "app/workbench/file_chooser.h"
#include "app/workbench/file_queue.h"
#include "app/workbench/latest_task.h"
#include "app/workbench/workbench.h"

#include <QTimer>
#include <QWidget>

#include <functional>
#include <optional>
#include <string>
#include <vector>

class QLabel;
class QStackedWidget;

namespace halbench::widgets {
class FigureView;
} // namespace halbench::widgets

namespace halbench::app {

class SignalBox;

/// A panel whose picture is made from live signals: on another thread, four times a second at most, and only
/// while somebody looks. Until there was a device it says what it is for.
class LivePicture : public QWidget {
    Q_OBJECT

public:
    void setFileChooser(FileChooser chooser) { m_chooser = std::move(chooser); }

Q_SIGNALS:
    void connectRequested(); ///< of the simulated motor, while there is nothing to show

protected:
    LivePicture(Workbench& bench, QWidget* parent);

    /// The page for who has no device yet, and the content; begins to ask.
    void begin(const QString& title, const QString& purpose, QWidget* content);
    /// The picture; Ctrl+E saves it, at first under this name.
    widgets::FigureView* makeView(QWidget* parent, const QString& toolTip, const QString& fileName);
    /// Asks for a file for a picture that is another widget's.
    void savePictureAs(const QString& fileName, const widgets::PictureSaving& taken);
    /// What the picture shows, as a table: Ctrl+Alt+E, in the menus of `views` too, at first under this name.
    void addData(const QList<QWidget*>& views, const QString& toolTip, const QString& fileName);
    /// What is said below the picture.
    QLabel* makeWords(QWidget* parent, const QString& accessibleName);
    /// A choice of a signal that the panel asks the device for.
    SignalBox* makeBox(QWidget* parent);

    virtual void takeCatalogue(const devices::Catalogue& catalogue) = 0;
    /// Starts `task` on what the history has now.
    virtual void compute() = 0;
    virtual bool isHeld() const { return false; }
    /// Makes the text of the table, on any thread; none while nothing is shown.
    using Table = std::function<std::string()>;
    virtual Table table() const { return {}; }

    /// Drops what is being computed, for another question.
    void askAnew();
    void sayWarning(const Error& error);
    DisplayQuantity shown(const SignalBox& box) const;
    Workbench& bench() const { return m_bench; }
    LatestTask& task() { return m_task; }

    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void onDevice();
    void onDerived();
    void want();
    void ask();
    void saveData(const QString& fileName);

    Workbench& m_bench;
    FileChooser m_chooser;
    QStackedWidget* m_pages = nullptr;
    QLabel* m_words = nullptr;
    std::vector<SignalBox*> m_boxes;
    QTimer m_timer;
    std::optional<std::uint64_t> m_seen; ///< revision of the history
    FileQueue m_files;
    LatestTask m_task; ///< last: what it computes ends first
};

} // namespace halbench::app
