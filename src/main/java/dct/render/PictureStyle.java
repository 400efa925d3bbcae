package dct.render;

/** How a scene becomes a picture: as a figure of its own, or as a window shows it. */
public sealed interface PictureStyle permits Figure, PictureView {}
