package dct.ui;

import dct.ui.command.CommandRegistry;

/** A window that has commands. */
interface CommandWindow {

  /** All its commands. */
  CommandRegistry commands();
}
