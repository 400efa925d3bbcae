/**
 * The mouse modes: small objects that turn presses, drags and releases in model coordinates into
 * edits. They know a narrow {@link dct.ui.tool.ToolContext} and no window.
 */
package dct.ui.tool;
