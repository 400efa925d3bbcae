package dct.ui.menu;

import dct.ui.command.CommandRegistry;

/** A window that has commands. */
public interface CommandWindow {

  /** All its commands. */
  CommandRegistry commands();
}
