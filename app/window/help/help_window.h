#pragma once

#include <QStringList>
#include <QWidget>

#include <functional>

class QAction;
class QToolButton;

namespace halbench::app {

class HelpText;

/// The pages of resources/help, compiled in, in the language of the window; a page that it does not have is
/// shown in English and says so. Links lead from page to page, Back returns, Ctrl+W closes. Carries a small
/// STOP. Esc closes it too where its owner knows that there is nothing to stop (stop_guard.h).
class HelpWindow : public QWidget {
    Q_OBJECT

public:
    explicit HelpWindow(const QString& page, QWidget* parent = nullptr);
    /// `address`: a page, a page and a section of it ("identification.md#6-calibrations"), or "#section"; a
    /// section is named as in the page that is shown, or as in the English one.
    void openPage(const QString& address);

    void setNothingToStop(std::function<bool()> isNothingToStop);

Q_SIGNALS:
    void stopRequested();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void buildBar();
    QToolButton* makeClose();
    void showPage(const QString& page);
    void goBack();

    QString m_language; ///< of the window when it was made
    std::function<bool()> m_isNothingToStop;
    HelpText* m_text = nullptr;
    QAction* m_back = nullptr;
    QStringList m_visited; ///< the last one is shown
    QString m_section;     ///< where the page was opened; empty: at its top
};

} // namespace halbench::app
