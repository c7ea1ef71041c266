#pragma once

#include <QStringList>
#include <QWidget>

class QAction;

namespace halbench::app {

class HelpText;

/// The pages of resources/help, compiled in, in the language of the window; a page that it does not have is
/// shown in English and says so. Links lead from page to page, Back returns. Carries a small STOP.
class HelpWindow : public QWidget {
    Q_OBJECT

public:
    explicit HelpWindow(const QString& page, QWidget* parent = nullptr);
    /// `address`: a page, a page and a section of it ("identification.md#6-calibrations"), or "#section"; a
    /// section is named as in the page that is shown, or as in the English one.
    void openPage(const QString& address);

Q_SIGNALS:
    void stopRequested();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void buildBar();
    void showPage(const QString& page);
    void goBack();

    QString m_language; ///< of the window when it was made
    HelpText* m_text = nullptr;
    QAction* m_back = nullptr;
    QStringList m_visited; ///< the last one is shown
    QString m_section;     ///< where the page was opened; empty: at its top
};

} // namespace halbench::app
