// The motor of a phone that shows the page, for device_list_web.cpp.
addToLibrary({
  $webVibration: {again: 0},

  // A browser of a computer has the function as well, and no motor.
  web_vibrates__proxy: 'sync',
  web_vibrates: () => typeof navigator !== 'undefined' && navigator.vibrate && typeof matchMedia !== 'undefined' &&
      matchMedia('(pointer: coarse)').matches ? 1 : 0,

  web_vibrate__deps: ['$webVibration'],
  web_vibrate: (at, count, loop) => {
    const ms = Array.from(HEAP32.subarray(at >> 2, (at >> 2) + count));
    clearInterval(webVibration.again);
    navigator.vibrate(count > 0 ? ms : 0);
    const length = ms.reduce((sum, one) => sum + one, 0);
    if (loop && length > 0) webVibration.again = setInterval(() => navigator.vibrate(ms), length);
  },
});
