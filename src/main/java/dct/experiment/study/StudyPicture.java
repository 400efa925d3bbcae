package dct.experiment.study;

import dct.render.Scene;

/**
 * A picture of a trial.
 *
 * @param method what was done
 * @param scene what came out
 */
public record StudyPicture(String method, Scene scene) {}
